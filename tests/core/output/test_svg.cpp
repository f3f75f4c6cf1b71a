#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/image/colour.h"
#include "core/output/drawing_format.h"
#include "core/text/text_lines.h"

using namespace dapple;

namespace {

constexpr PageSize kA4Wide{.width_mm = 297, .height_mm = 210, .mm_per_page_unit = 297};

Dots dots_at(std::initializer_list<std::pair<float, float>> places) {
    Dots dots;
    for (const auto& [x, y] : places) {
        dots.x.push_back(x);
        dots.y.push_back(y);
        dots.threshold.push_back(0.5f);
    }
    return dots;
}

pugi::xml_document svg_of(const Dots& dots, const PageSize& size, InkPage page) {
    page.size = size;
    page.dots = stream_of(dots);
    std::ostringstream out;
    write_svg(out, page);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_string(out.str().c_str());
    REQUIRE_MESSAGE(parsed, parsed.description());
    return document;
}

std::size_t count_of(pugi::xml_node parent, const char* name) {
    std::size_t count = 0;
    for (const pugi::xml_node& child : parent.children(name)) count += child ? 1 : 0;
    return count;
}

std::string fixed(double value, int decimals) {
    std::ostringstream out;
    TextBuffer text(out);
    text.fixed(value, decimals);
    text.flush();
    return out.str();
}

}  // namespace

TEST_CASE("an SVG says its size in millimetres and its coordinates are 96ths of an inch") {
    InkPage style;
    style.dot_radius_mm = 25.4;
    const pugi::xml_document document = svg_of(dots_at({{0.5f, 0.25f}}), kA4Wide, style);
    const pugi::xml_node root = document.child("svg");
    CHECK(root.attribute("width").value() == std::string("297mm"));
    CHECK(root.attribute("height").value() == std::string("210mm"));
    // A4 in px, to four decimals: 210 * 96 / 25.4.
    CHECK(root.attribute("viewBox").value() == std::string("0 0 1122.5197 793.7008"));
    const pugi::xml_node circle = root.child("g").child("circle");
    CHECK(circle.attribute("cx").as_double() == doctest::Approx(297.0 / 2 * 96 / 25.4).epsilon(1e-5));
    CHECK(circle.attribute("cy").as_double() == doctest::Approx(297.0 / 4 * 96 / 25.4).epsilon(1e-5));
    CHECK(circle.attribute("r").as_double() == 96);
}

TEST_CASE("each pen has a layer, a direct child of the root, its number first in the label") {
    InkPage style;
    const pugi::xml_document black = svg_of(dots_at({{0.1f, 0.1f}, {0.2f, 0.3f}}), kA4Wide, style);
    const pugi::xml_node layer = black.child("svg").child("g");
    CHECK(layer.attribute("inkscape:groupmode").value() == std::string("layer"));
    CHECK(layer.attribute("inkscape:label").value() == std::string("1 Black"));
    CHECK(layer.attribute("id").value() == std::string("layer1"));
    CHECK(layer.attribute("fill").value() == std::string("#000000"));
    CHECK(count_of(layer, "circle") == 2);
    CHECK(count_of(black.child("svg"), "g") == 1);
    CHECK(black.child("svg").attribute("xmlns:inkscape"));

    style.ink = parse_colour("#1d3557");
    const pugi::xml_document blue = svg_of(dots_at({{0.1f, 0.1f}}), kA4Wide, style);
    CHECK(blue.child("svg").child("g").attribute("inkscape:label").value() == std::string("1 #1d3557"));
    CHECK(blue.child("svg").child("g").attribute("fill").value() == std::string("#1d3557"));
}

TEST_CASE("no dot has radius 0, however small it is to be") {
    InkPage style;
    style.dot_radius_mm = 1e-9;
    const pugi::xml_document document = svg_of(dots_at({{0.5f, 0.5f}}), kA4Wide, style);
    CHECK(document.child("svg").child("g").child("circle").attribute("r").as_double() > 0);
}

TEST_CASE("an SVG has a background only if asked for") {
    InkPage style;
    CHECK(!svg_of(dots_at({{0.5f, 0.5f}}), kA4Wide, style).child("svg").child("rect"));
    style.background = parse_colour("#fed");
    const pugi::xml_document document = svg_of(dots_at({{0.5f, 0.5f}}), kA4Wide, style);
    const pugi::xml_node first = document.child("svg").first_child();
    CHECK(first.attribute("inkscape:label").value() == std::string("% Background"));
    CHECK(first.child("rect").attribute("fill").value() == std::string("#ffeedd"));
    CHECK(!document.child("svg").child("rect"));
}

TEST_CASE("tiles are the second layer, one colour a level") {
    const std::vector<PlacedTile> tiles{{.level = 0, .x = 0, .y = 0, .side = 1, .orientation = {}},
                                        {.level = 1, .x = 0, .y = 0, .side = 0.5, .orientation = {}},
                                        {.level = 1, .x = 0.5, .y = 0, .side = 0.5, .orientation = {}}};
    InkPage style;
    style.tiles = tiles;
    const pugi::xml_document document = svg_of(dots_at({{0.5f, 0.5f}}), kA4Wide, style);
    const pugi::xml_node layer = document.child("svg").child("g").next_sibling("g");
    CHECK(layer.attribute("inkscape:label").value() == std::string("% Tiles"));
    std::set<std::string> strokes;
    std::size_t outlines = 0;
    for (const pugi::xml_node& level : layer.children("g")) {
        strokes.insert(level.attribute("stroke").value());
        outlines += count_of(level, "rect");
    }
    CHECK(strokes.size() == 2);
    CHECK(outlines == 3);
}

TEST_CASE("outlines end at the page's edges, and those beyond or all around it are none") {
    const PageSize page{.width_mm = 50, .height_mm = 25, .mm_per_page_unit = 100};
    const std::vector<PlacedTile> tiles{{.level = 0, .x = -0.25, .y = -0.5, .side = 1, .orientation = {}},
                                        {.level = 1, .x = -0.25, .y = 0, .side = 0.5, .orientation = {}},
                                        {.level = 1, .x = 0.25, .y = 0, .side = 0.5, .orientation = {}},
                                        {.level = 1, .x = -0.25, .y = -0.5, .side = 0.5, .orientation = {}},
                                        {.level = 2, .x = 0, .y = 0.25, .side = 0.25, .orientation = {}},
                                        {.level = 2, .x = -0.25, .y = 0, .side = 0.25, .orientation = {}},
                                        {.level = 2, .x = 0.25, .y = 0, .side = 0.25, .orientation = {}}};
    InkPage style;
    style.tiles = tiles;
    const pugi::xml_document document = svg_of(dots_at({{0.1f, 0.1f}}), page, style);
    std::set<std::string> outlines;
    for (const pugi::xml_node& level : document.child("svg").child("g").next_sibling("g").children("g")) {
        for (const pugi::xml_node& tile : level.children("rect")) {
            const auto mm = [&](const char* name) {
                return std::to_string(std::lround(tile.attribute(name).as_double() * 25.4 / 96));
            };
            outlines.insert(level.attribute("id").value() + (" " + mm("x") + "," + mm("y")) + " " +
                            mm("width") + "x" + mm("height"));
        }
    }
    // The first two of level 1 reach over the page's left, right and lower edges.
    CHECK(outlines == std::set<std::string>{"level1 0,0 25x25", "level1 25,0 25x25", "level2 25,0 25x25"});
}

TEST_CASE("dots far apart on paper stay apart in an SVG, however many there are") {
    // A hundred thousand dots on a stamp: 0.06 px apart.
    Dots dots;
    constexpr int side = 320;
    for (int i = 0; i < side * side; ++i) {
        dots.x.push_back(static_cast<float>(i % side) / side);
        dots.y.push_back(static_cast<float>(i / side) / side);
    }
    const PageSize stamp{.width_mm = 5, .height_mm = 5, .mm_per_page_unit = 5};
    const pugi::xml_document document = svg_of(dots, stamp, {});
    std::set<std::pair<std::string, std::string>> places;
    for (const pugi::xml_node& circle : document.child("svg").child("g").children("circle")) {
        places.emplace(circle.attribute("cx").value(), circle.attribute("cy").value());
    }
    CHECK(places.size() == dots.size());
}

TEST_CASE("numbers are rounded to their decimals and end in no zeros") {
    CHECK(fixed(12.5, 3) == "12.5");
    CHECK(fixed(3, 2) == "3");
    CHECK(fixed(0, 2) == "0");
    CHECK(fixed(0.001, 2) == "0");
    CHECK(fixed(-0.001, 2) == "0");
    CHECK(fixed(-0.25, 2) == "-0.25");
    CHECK(fixed(1.005001, 2) == "1.01");
    CHECK(fixed(0.05, 2) == "0.05");
    CHECK(fixed(0.999, 2) == "1");
    CHECK(fixed(123456.0625, 4) == "123456.0625");
    CHECK(fixed(999'999'999, 9) == "999999999");
    CHECK(fixed(0.125, 2) == "0.13");
    CHECK(fixed(-0.125, 2) == "-0.13");
    CHECK(fixed(2.5, 0) == "3");
    CHECK(fixed(0.49999999999999994, 0) == "0");
}

TEST_CASE("colours are read in the two ways people write them, and refused in words otherwise") {
    CHECK(hex_of(parse_colour("#1A2b3c")) == "#1a2b3c");
    CHECK(hex_of(parse_colour("1a2b3c")) == "#1a2b3c");
    CHECK(hex_of(parse_colour("#0f8")) == "#00ff88");
    CHECK(pen_name(kWhite) == "White");
    for (const char* wrong : {"", "#", "#12345", "#1234567", "#gggggg", "red", "#-12345", "# 12345"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_colour(wrong), std::runtime_error);
    }
}
