#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/reports/plot.h"

using namespace dapple;

namespace {

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    REQUIRE(document.load_string(svg.c_str()));
    return document;
}

std::vector<std::string> texts(const pugi::xml_document& document) {
    std::vector<std::string> result;
    for (const pugi::xpath_node& node : document.select_nodes("//text"))
        result.push_back(node.node().text().get());
    return result;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace

TEST_CASE("ticks are round numbers from end to end") {
    using Ticks = std::vector<double>;
    CHECK(plot_ticks(0, 2, 8, AxisScale::linear).size() == 5);  // 0, 0.5 ... 2
    CHECK(plot_ticks(0, 10, 5, AxisScale::linear) == Ticks{0, 2, 4, 6, 8, 10});
    CHECK(plot_ticks(-3.2, 7.9, 5, AxisScale::linear) == Ticks{0, 5});
    CHECK(plot_ticks(1, 1000, 8, AxisScale::logarithmic) == Ticks{1, 10, 100, 1000});
    const Ticks tiny = plot_ticks(0.00011, 0.00019, 4, AxisScale::linear);
    REQUIRE(tiny.size() == 4);
    CHECK(tiny.front() == doctest::Approx(0.00012));
    CHECK(plot_ticks(1e-30, 1e30, 6, AxisScale::logarithmic).size() <= 8);
    for (const double span : {1.0, 3.7, 1e-9, 4e12})
        for (const double start : {0.0, -2.3, 100.0}) {
            const Ticks ticks = plot_ticks(start * span, start * span + span, 6, AxisScale::linear);
            CHECK(ticks.size() >= 2);
            CHECK(ticks.size() <= 8);
        }
}

TEST_CASE("a line goes through its points, places linear in the values") {
    Plot plot;
    plot.x = {.label = "time, s", .least = 0.0, .most = 4.0};
    plot.y = {.label = "height, m", .least = 0.0, .most = 10.0};
    plot.curves = {{.name = "", .points = {{0, 0}, {2, 5}, {4, 10}}}};
    const auto document = parsed(svg_plot(plot));
    const pugi::xml_node inner = document.child("svg").child("svg");
    const double width = inner.attribute("width").as_double(), height = inner.attribute("height").as_double();
    std::istringstream d(inner.child("path").attribute("d").value());
    char command = 0;
    for (int i = 0; i < 3; ++i) {
        double x = -1, y = -1;
        d >> command >> x >> y;
        CHECK(command == (i == 0 ? 'M' : 'L'));
        CHECK(x == doctest::Approx(width * i / 2).epsilon(1e-3));
        CHECK(y == doctest::Approx(height * (2 - i) / 2).epsilon(1e-3));
    }
}

TEST_CASE("axes have their labels, ticks their numbers, curves a legend, levels a line") {
    Plot plot;
    plot.title = "Error <and> \"count\"";
    plot.x = {.label = "count & more", .scale = AxisScale::logarithmic};
    plot.y = {.label = "error"};
    plot.curves = {{.name = "ours", .points = {{1, 1}, {1000, 3}}},
                   {.name = "theirs", .points = {{1, 2}, {1000, 2}}, .mark = PlotMark::dots}};
    plot.levels = {{2.5, "limit"}, {99, "far off"}};
    const auto document = parsed(svg_plot(plot));
    CHECK(std::string(document.child("svg").child("title").text().get()) == plot.title);
    const auto words = texts(document);
    for (const char* word :
         {"count & more", "error", "1", "10", "100", "1000", "1.5", "3", "ours", "theirs", "limit"}) {
        CAPTURE(word);
        CHECK(contains(words, word));
    }
    CHECK_FALSE(contains(words, "far off"));
    CHECK(document.select_nodes("//circle").size() == 2);
}

TEST_CASE(
    "a legend of many curves goes on in further lines, none of which leaves the picture or meets the axes") {
    Plot plot;
    for (int i = 0; i < 9; ++i)
        plot.curves.push_back({.name = "a curve with a long name", .points = {{0, 0}, {1, 1}}});
    const auto document = parsed(svg_plot(plot));
    const double top = document.child("svg").child("svg").attribute("y").as_double();
    std::set<double> lines;
    int names = 0;
    for (const auto& node : document.select_nodes("//text[text()='a curve with a long name']")) {
        ++names;
        const double x = node.node().attribute("x").as_double(), y = node.node().attribute("y").as_double();
        CHECK(x + 24 * 6 < plot.width);
        CHECK(y < top);
        lines.insert(y);
    }
    CHECK(names == 9);
    CHECK(lines.size() == 5);
}

TEST_CASE("an axis of powers of ten writes all the large ones alike") {
    Plot plot;
    plot.x = {.label = "dots", .scale = AxisScale::logarithmic};
    plot.curves = {{.name = "", .points = {{100, 20000}, {1e7, 60000}}}};
    const auto words = texts(parsed(svg_plot(plot)));
    for (const char* word : {"100", "1000", "10⁴", "10⁵", "10⁶", "10⁷", "20000"}) {
        CAPTURE(word);
        CHECK(contains(words, word));
    }
    CHECK_FALSE(contains(words, "10000"));
    CHECK_FALSE(contains(words, "100000"));
}

TEST_CASE("values that cannot be drawn break the line") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Plot plot;
    plot.curves = {{.name = "", .points = {{0, 1}, {1, 2}, {2, nan}, {3, 4}, {4, 5}}}};
    const auto document = parsed(svg_plot(plot));
    const std::string d = document.child("svg").child("svg").child("path").attribute("d").value();
    CHECK(std::count(d.begin(), d.end(), 'M') == 2);
    CHECK(std::count(d.begin(), d.end(), 'L') == 2);
    CHECK(d.find("nan") == d.npos);
    plot.y.scale = AxisScale::logarithmic;
    plot.curves[0].points[2].y = 0;
    CHECK(svg_plot(plot).find("inf") == std::string::npos);
}

TEST_CASE("a plot of nothing, of one point and of a constant is still a plot") {
    for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
        Plot plot;
        plot.x.scale = plot.y.scale = scale;
        CHECK(texts(parsed(svg_plot(plot))).size() > 4);
        plot.curves = {{.name = "", .points = {{2, 3}}}};
        CHECK(texts(parsed(svg_plot(plot))).size() > 4);
        plot.curves[0].points.push_back({4, 3});
        CHECK(svg_plot(plot).find("nan") == std::string::npos);
    }
}
