#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lab/commands/commands.h"
#include "tests/file_text.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

// What stands below one heading of the page, up to the next.
struct PageSection {
    std::string heading{};
    std::vector<std::string> captions{}, sentences{};
    std::vector<std::vector<std::string>> rows{};  // cells of the tables
    std::vector<pugi::xml_node> images{}, plots{};
};

std::string whole_text(const pugi::xml_node& node) {
    std::string text;
    for (const pugi::xpath_node& part : node.select_nodes(".//text()")) text += part.node().value();
    return text;
}

std::vector<PageSection> sections_of(const pugi::xml_document& page) {
    std::vector<PageSection> sections;
    for (const pugi::xml_node& node : page.child("html").child("body").children()) {
        const std::string name = node.name();
        if (name == "h2") sections.push_back({.heading = whole_text(node)});
        if (sections.empty()) continue;
        PageSection& section = sections.back();
        if (name == "p") section.sentences.push_back(whole_text(node));
        for (const pugi::xpath_node& caption : node.select_nodes(".//figcaption"))
            section.captions.push_back(whole_text(caption.node()));
        for (const pugi::xpath_node& image : node.select_nodes(".//img"))
            section.images.push_back(image.node());
        for (const pugi::xml_node& plot : node.children("svg")) section.plots.push_back(plot);
        for (const pugi::xpath_node& row : node.select_nodes(".//tbody/tr")) {
            section.rows.emplace_back();
            for (const pugi::xml_node& cell : row.node().children("td"))
                section.rows.back().push_back(whole_text(cell));
        }
    }
    return sections;
}

// The straight pieces of a plot's first curve, as x and y from 0 to 1 from the lower left.
std::vector<std::array<double, 4>> pieces_of(const pugi::xml_node& plot) {
    const pugi::xml_node inner = plot.child("svg");
    const double width = inner.attribute("width").as_double(), height = inner.attribute("height").as_double();
    std::vector<std::array<double, 4>> pieces;
    const std::string path = inner.child("path").attribute("d").value();
    const std::regex piece("M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)");
    std::string left = path;
    for (std::smatch match; std::regex_search(left, match, piece); left = match.suffix())
        pieces.push_back({std::stod(match[1]) / width, 1 - std::stod(match[2]) / height,
                          std::stod(match[3]) / width, 1 - std::stod(match[4]) / height});
    CHECK(std::count(path.begin(), path.end(), 'L') == static_cast<long>(pieces.size()));
    return pieces;
}

bool page_says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Appendix A from its first point: doubled modulo 65535, and always the point farthest from all before.
std::vector<std::array<long, 2>> appendix_a() {
    constexpr long kPeriod = 65535;
    std::vector<std::array<long, 2>> left{{14217, 2895}}, list;
    while (left.size() < 16) left.push_back({left.back()[0] * 2 % kPeriod, left.back()[1] * 2 % kPeriod});
    const auto gap = [&](const std::array<long, 2>& p) {
        long nearest = std::numeric_limits<long>::max();
        for (const auto& q : list) {
            long sum = 0;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const long apart = std::abs(p[axis] - q[axis]), round = std::min(apart, kPeriod - apart);
                sum += round * round;
            }
            nearest = std::min(nearest, sum);
        }
        return nearest;
    };
    while (!left.empty()) {
        const auto next = std::max_element(left.begin(), left.end(),
                                           [&](const auto& p, const auto& q) { return gap(p) < gap(q); });
        list.push_back(*next);
        left.erase(next);
    }
    return list;
}

}  // namespace

TEST_CASE("the page says what is the paper's and what is ours, and each figure is what its caption says") {
    const TemporaryFolder folder;
    const Outcome outcome = run_lab("reproduce -o " + (folder / "paper").string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(page_says(outcome.out, "the paper prints 14.00 %, but it is 13.99499 %"));
    CHECK(page_says(outcome.out, "53 of 54 numbers are equal"));

    pugi::xml_document page;
    REQUIRE(page.load_file((folder / "paper/index.html").c_str(), pugi::parse_full));
    for (const pugi::xpath_node& node : page.select_nodes("//@src"))
        CHECK(std::string(node.attribute().value()).starts_with("data:image/"));
    CHECK(page.select_nodes("//tr[@class='bad']").empty());
    const std::vector<PageSection> sections = sections_of(page);
    const auto section = [&](const std::string& start) -> const PageSection& {
        for (const PageSection& one : sections)
            if (one.heading.starts_with(start)) return one;
        FAIL("no section " << start);
        return sections.front();
    };

    // Printed is what the paper prints: shares to two decimals, radii to four digits.
    std::vector<std::string> printed;
    for (const auto& row : section("Numbers of the text").rows) {
        printed.push_back(row.at(2));
        CHECK((row[4] == "yes") == (row[2] != "14.00 %"));
        CHECK((row[2] == row[3]) == (row[2] != "14.00 %"));
    }
    CHECK(printed == std::vector<std::string>{"19.64 %", "17.62 %", "16.12 %", "14.00 %", "0.6966", "0.6528",
                                              "0.8324", "0.7141", "0.6713", "0.6588"});
    std::size_t in_file = 0;
    for (const auto& number : nlohmann::json::parse(text_of(folder / "paper/numbers.json"))) {
        CAPTURE(number.dump());
        if (number["origin"] == "printed") ++in_file;
        if (number["table"] == "not in the paper" || number["table"] == "figure 8")
            CHECK(number["origin"] == "ours");
        CHECK(number["equal"] == (number["expected"] == number["ours"]));
    }
    CHECK(in_file == printed.size() + 16);  // and the points of Appendix A

    CHECK(page.select_nodes("//th[.='Printed']").size() == 2);
    const PageSection& table1 = section("Table 1: Appendix A");
    const auto expected = appendix_a();
    REQUIRE(table1.rows.size() == 16);
    for (std::size_t rank = 0; rank < 16; ++rank) {
        const auto [x, y] = expected[rank];
        const std::string point =
            fmt::format("{}, {} = {:.8f}, {:.8f}", x, y, double(x) / 65535, double(y) / 65535);
        CHECK(table1.rows[rank].at(0) == std::to_string(rank));
        CHECK(table1.rows[rank].at(2) == point);
        CHECK(table1.rows[rank].at(3) == point);
    }

    CHECK(section("Figures 1 and 2: a tile and its half-size copies; a hierarchical tile").images.size() ==
          1);
    const PageSection& functions = section("Figures 3 and 4: plots of f and f^(3)");
    CHECK(functions.images.empty());
    REQUIRE(functions.plots.size() == 2);
    for (const int pieces : {2, 8}) {
        CAPTURE(pieces);
        const pugi::xml_node& plot = functions.plots[pieces == 2 ? 0 : 1];
        const auto curve = pieces_of(plot);
        REQUIRE(curve.size() == static_cast<std::size_t>(pieces));
        for (int i = 0; i < pieces; ++i) {
            const std::array ends{double(i) / pieces, 0.0, double(i + 1) / pieces, 1.0};
            for (std::size_t k = 0; k < 4; ++k)
                CHECK(std::abs(curve[static_cast<std::size_t>(i)][k] - ends[k]) < 1e-4);
        }
        // Ticks where pieces end; dots where they meet the diagonal.
        const pugi::xml_node inner = plot.child("svg");
        const double width = inner.attribute("width").as_double(),
                     height = inner.attribute("height").as_double();
        const std::string diagonal = inner.select_nodes("path")[1].node().attribute("d").value();
        CHECK(diagonal == fmt::format("M0.00 {:.2f}L{:.2f} 0.00", height, width));
        const pugi::xpath_node_set dots = inner.select_nodes(".//circle");
        REQUIRE(dots.size() == static_cast<std::size_t>(pieces - 1));
        for (int k = 0; k < pieces - 1; ++k) {
            const pugi::xml_node dot = dots[static_cast<std::size_t>(k)].node();
            CHECK(std::abs(dot.attribute("cx").as_double() / width - double(k) / (pieces - 1)) < 1e-4);
            CHECK(std::abs(1 - dot.attribute("cy").as_double() / height - double(k) / (pieces - 1)) < 1e-4);
        }
        for (int k = 1; k < pieces; ++k)
            CHECK(plot.select_nodes(fmt::format("g/text[.='{}/{}']", k, pieces).c_str()).size() == 2);
    }

    const auto each_says = [](const PageSection& figure, const std::vector<std::string>& words) {
        REQUIRE(figure.captions.size() >= words.size());
        for (std::size_t i = 0; i < words.size(); ++i) {
            CAPTURE(figure.captions[i]);
            CHECK(page_says(figure.captions[i], words[i]));
        }
    };
    const PageSection& stippled = section("Figures 5 and 6: stippled pictures");
    // As printed, and ours: equal, or one more.
    each_says(stippled, {"Printed: 44,202 dots; ours: 44,20", "Printed: 44,775 dots; ours: 44,77",
                         "Printed: 41,709 dots; ours: 41,7", "Printed: 37,997 dots; ours: 37,99",
                         "Printed: 38,714 dots; ours: 38,71", "Printed: 30,583 dots; ours: 30,58",
                         "Printed: 28,291 dots; ours: 28,29", "Printed: 36,809 dots; ours: 36,8"});
    CHECK(page_says(stippled.sentences.at(0), "approximately 80 ms"));
    CHECK(page_says(stippled.sentences.at(0), "The pictures are our choice"));
    const PageSection& lights = section("Figure 7: environment maps with samples");
    each_says(lights, {"Grace Cathedral, printed: 8,234 samples; a sky made by this program, ours: 8,23",
                       "St. Peter's, printed: 12,636 samples; a sky made by this program, ours: 12,63",
                       "Uffizi, printed: 10,606 samples; a sky made by this program, ours: 10,60",
                       "Galileo's Tomb, printed: 34,299 samples; a sky made by this program, ours: 34,"});
    CHECK(page_says(lights.sentences.at(0), "approximately 30 ms"));
    CHECK(page_says(lights.sentences.at(0), "the sine is our choice"));
    // No picture shares its row with another, so that all are as wide.
    CHECK(page.select_nodes("//div[@class='side one']//img[@alt='an environment map with its samples']")
              .size() == 4);

    CHECK(section("Figure 8: the algorithm").rows.at(0).at(3) == "54608");
    const PageSection& spectra = section("Not in the paper: power spectra");
    each_says(spectra, {"periodicity 1.00", "periodicity 1.00", "periodicity 1.00", "aperiodic4096"});
    CHECK(!page_says(spectra.captions.at(3), "periodicity 1.00"));
    CHECK(page_says(spectra.sentences.at(0), "The first three are of the tile of Appendix A"));
    // A peak of the repeated tile: about half of all dots move as one.
    CHECK(page_says(spectra.captions.at(2), "39936 dots, highest bin 21744"));
    std::smatch highest;
    REQUIRE(std::regex_search(spectra.captions.at(3), highest, std::regex("highest bin ([0-9]+)")));
    CHECK(page_says(spectra.sentences.at(0), "few orange dots, the highest of power " + highest[1].str()));

    const PageSection& ours = section("Not in the paper: more about its tiles");
    for (const char* value : {"0.640257", "0.638781", "0.649963", "11730,8925/16", "0.782220", "0.914419",
                              "0.715878", "0.917943", "0.744484", "0.832358", "0.679618"}) {
        CAPTURE(value);
        CHECK(std::ranges::any_of(ours.rows, [&](const auto& row) { return row.at(3) == value; }));
    }
    // With 20 points, the paper's "very symmetric" tiles and the fourth, "not symmetric".
    CHECK(page_says(section("Not in the paper: 16 points from four tiles of 4").sentences.at(0),
                    "0013 0211 0233 1322; 0033 0132 0231 1122; 0103 0212 0323 1213, reach 0.744484"));
    std::vector<std::string> symmetric;
    for (const auto& row : ours.rows)
        if (page_says(row.at(0), "of 20 points: points that a turn or mirror takes to points"))
            symmetric.push_back(row.at(3));
    CHECK(symmetric == std::vector<std::string>{"20", "20", "14", "8"});
}

TEST_CASE("a number that differs is an error that says where to look") {
    const std::vector<ComparedNumber> rows{
        {.what = "a", .expected = "1.00", .ours = "1.00", .source = "paper"},
        {.what = "b", .expected = "2.00", .ours = "2.01", .source = "paper"},
        {.what = "c", .expected = "3.00", .ours = "2.99", .source = "paper", .known = "it is 2.99"}};
    CHECK_THROWS_WITH_AS(
        check_equal(rows, "paper/index.html"),
        "1 of 3 numbers differ from what should come out; they are marked in paper/index.html",
        std::runtime_error);
    CHECK_NOTHROW(check_equal(std::vector(rows.begin(), rows.begin() + 1), "paper/index.html"));
}

TEST_CASE("a folder that cannot be, and a map that is none, are refused in words") {
    const TemporaryFolder folder;
    put_text(folder / "file", "x");
    const auto refuses = [&](const std::string& arguments, const std::string& words) {
        const Outcome outcome = run_lab("reproduce " + arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.status != 0);
        CHECK(outcome.sentences() == 1);
        CHECK(outcome.err.find(words) != std::string::npos);
    };
    refuses("-o " + (folder / "file").string(), "is a file, not a folder");
    refuses("-o " + (folder / "file/b").string(), "the folder cannot be made");
    refuses("", "--output");
    CHECK(text_of(folder / "file") == "x");
}
