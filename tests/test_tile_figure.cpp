// The figure of a tile, read as XML.

#include <doctest/doctest.h>

#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>

#include "core/output/tile_figure.h"
#include "core/tile/relink_search.h"

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
    return ranked(make_tile(aperiodic_rule(), even_words(points, 5)), RankingOrder::energy);
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
         {ranked(make_tile(14217, 2895, 16), RankingOrder::paper), turned_tile(64)}) {
        const pugi::xml_document figure = figure_of(stored);
        const auto copies = under(figure, "copies", "circle");
        std::set<std::size_t> met;
        for (const pugi::xpath_node& ring : under(figure, "coinciding", "circle")) {
            for (std::size_t i = 0; i < copies.size(); ++i) {
                const double dx =
                    copies[i].node().attribute("cx").as_double() - ring.node().attribute("cx").as_double();
                const double dy =
                    copies[i].node().attribute("cy").as_double() - ring.node().attribute("cy").as_double();
                if (std::hypot(dx, dy) < 0.02) met.insert(i);
            }
        }
        CHECK(met.size() == stored.tile.size());
    }
}

TEST_CASE("a small tile's figure has each rank once, at its point") {
    const StoredTile stored = ranked(make_tile(14217, 2895, 16), RankingOrder::paper);
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
