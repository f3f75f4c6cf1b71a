// The figure of a tile, read as XML.

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>

#include "io/reports/tile_figure.h"
#include "lab/search/relink_search.h"

namespace dapple {
namespace {

pugi::xml_document figure_of(const StoredTile& stored) {
    std::ostringstream out;
    write_tile_figure(out, stored);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_string(out.str().c_str());
    REQUIRE_MESSAGE(parsed, parsed.description());
    return document;
}

pugi::xpath_node_set under(const pugi::xml_document& figure, const std::string& id, const std::string& what) {
    return figure.select_nodes(("//g[@id='" + id + "']//" + what).c_str());
}

StoredTile turned_tile(std::size_t points) {
    return ranked(make_tile(aperiodic_rule(), even_words(points, 5)), RankingMethod::energy);
}

}  // namespace

TEST_CASE("a tile's figure shows every point, every copy, every rank and growing beginnings") {
    for (const std::size_t n : {std::size_t{16}, std::size_t{64}, std::size_t{128}}) {
        const pugi::xml_document figure = figure_of(turned_tile(n));
        CHECK(under(figure, "tile", "circle").size() == n);
        CHECK(under(figure, "copies", "circle").size() == 4 * n);
        CHECK(under(figure, "coinciding", "circle").size() == n);
        CHECK(under(figure, "ranks", n <= 64 ? "text" : "circle").size() == n);
        for (std::size_t k = 1; k <= 4; ++k)
            CHECK(under(figure, "first-" + std::to_string(k), "circle").size() == k * n / 4);
    }
}

TEST_CASE("every circled point of a tile's figure lies on a point of a copy, and none twice") {
    for (const StoredTile& stored :
         {ranked(make_tile(14217, 2895, 16), RankingMethod::paper), turned_tile(64), turned_tile(1024)}) {
        const pugi::xml_document figure = figure_of(stored);
        const auto centre = [](const pugi::xpath_node& circle) {
            return glm::dvec2(circle.node().attribute("cx").as_double(),
                              circle.node().attribute("cy").as_double());
        };
        std::vector<glm::dvec2> copies;
        for (const pugi::xpath_node& copy : under(figure, "copies", "circle")) copies.push_back(centre(copy));
        std::set<std::size_t> met;
        for (const pugi::xpath_node& ring : under(figure, "coinciding", "circle")) {
            const glm::dvec2 place = centre(ring);
            for (std::size_t i = 0; i < copies.size(); ++i)
                if (glm::distance(copies[i], place) < 0.02) met.insert(i);
        }
        CHECK(met.size() == stored.tile.size());
    }
}

TEST_CASE("own points are seen among the copies: circled in a small tile, black in a large one") {
    const pugi::xml_document small = figure_of(turned_tile(64)), large = figure_of(turned_tile(1024));
    const auto group = [](const pugi::xml_document& figure) {
        return figure.select_node("//g[@id='coinciding']").node();
    };
    const auto words = [](const pugi::xml_document& figure, const char* text) {
        return !figure.select_nodes((std::string("//text[contains(., '") + text + "')]").c_str()).empty();
    };
    CHECK(group(small).attribute("fill").value() == std::string("none"));
    CHECK(group(small).attribute("stroke-width").as_double() > 0.4);
    CHECK(words(small, "own points circled"));
    CHECK(group(large).attribute("fill").value() == std::string("#1d1d1f"));
    CHECK(words(large, "own points black"));
    // Larger than the copies' points, so not hidden among them.
    const double copy = under(large, "copies", "circle")[0].node().attribute("r").as_double();
    CHECK(under(large, "coinciding", "circle")[0].node().attribute("r").as_double() > 1.2 * copy);
}

TEST_CASE("no caption of a tile's figure is wider than its panel") {
    for (const std::size_t n : {std::size_t{64}, std::size_t{1024}}) {
        const pugi::xml_document figure = figure_of(turned_tile(n));
        for (const pugi::xpath_node& found : figure.select_nodes("/svg/text[@font-size='11.5']")) {
            const std::string text = found.node().text().get();
            CAPTURE(text);
            // A sans-serif letter is about half as wide as its size; panels of the upper row are 216 px.
            CHECK(double(text.size()) * 0.5 * 11.5 < 216);
        }
    }
}

TEST_CASE("a small tile's figure has each rank once, at its point") {
    const StoredTile stored = ranked(make_tile(14217, 2895, 16), RankingMethod::paper);
    const pugi::xml_document figure = figure_of(stored);
    std::set<int> ranks;
    const auto texts = under(figure, "ranks", "text");
    const auto points = under(figure, "tile", "circle");
    for (std::size_t i = 0; i < texts.size(); ++i) {
        ranks.insert(texts[i].node().text().as_int(-1));
        // Both panels have the same size and height on the page.
        const double shift =
            texts[i].node().attribute("x").as_double() - points[i].node().attribute("cx").as_double();
        CHECK(shift == doctest::Approx(2 * (216 + 26)).epsilon(1e-4));
    }
    CHECK(ranks.size() == 16);
    CHECK(*ranks.begin() == 0);
    CHECK(*ranks.rbegin() == 15);
}

}  // namespace dapple
