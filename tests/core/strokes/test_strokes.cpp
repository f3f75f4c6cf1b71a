// What a pen draws of dots: lines through them, their shapes, and both in every kind of file.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/output/drawing_format.h"
#include "core/output/pen_figures.h"
#include "core/output/raster.h"
#include "core/strokes/dot_shape.h"
#include "core/strokes/drawing_style.h"
#include "tests/machines.h"

namespace dapple {
namespace {

constexpr PageSize kStrokePage{.width_mm = 40, .height_mm = 30, .mm_per_page_unit = 40};

Dots random_dots(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> across(0, 1), down(0, 0.75f);
    Dots dots;
    for (std::size_t i = 0; i < count; ++i) {
        dots.x.push_back(across(random));
        dots.y.push_back(down(random));
    }
    return dots;
}

template <class Visit>
void for_each_line_of(const Strokes& strokes, const Visit& visit) {
    stream_of(strokes, 1).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
        for (std::size_t i = 1; i < points.size(); ++i) visit(points[i - 1], points[i]);
    });
}

double length_of(const Strokes& strokes) {
    double length = 0;
    for_each_line_of(strokes, [&](glm::dvec2 a, glm::dvec2 b) { length += glm::distance(a, b); });
    return length;
}

double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

double distance_to_line(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const double square = glm::dot(b - a, b - a);
    const double share = square > 0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0;
    return glm::distance(p, a + share * (b - a));
}

std::string complaint_about_mark(const std::string& text) {
    try {
        parse_dot_mark(text);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

// Strokes and touches of all kinds, in a page's millimetres.
Strokes some_strokes() {
    Strokes strokes = line_through(random_dots(130, 4), kStrokePage);
    for (const glm::dvec2 p : {glm::dvec2(5, 7), glm::dvec2(39, 29.5)}) {
        strokes.points.push_back(p);
        end_stroke(strokes);
    }
    strokes.points.insert(strokes.points.end(), {{1, 1}, {2, 1}, {2, 3.5}});
    end_stroke(strokes);
    return strokes;
}

}  // namespace

TEST_CASE("lines to the nearest are the relative neighbourhood graph, drawn once each, and none cross") {
    const Dots dots = random_dots(250, 3);
    using Line = std::pair<std::size_t, std::size_t>;
    const auto apart = [&](std::size_t a, std::size_t b) {
        return std::hypot(double(dots.x[a]) - dots.x[b], double(dots.y[a]) - dots.y[b]);
    };
    std::set<Line> graph;  // by the definition, each dot against each pair
    for (std::size_t a = 0; a < dots.size(); ++a) {
        for (std::size_t b = a + 1; b < dots.size(); ++b) {
            bool blocked = false;
            for (std::size_t c = 0; c < dots.size(); ++c)
                blocked |= std::max(apart(a, c), apart(b, c)) < apart(a, b);
            if (!blocked) graph.insert({a, b});
        }
    }
    const Strokes strokes = lines_to_nearest(dots, kStrokePage);
    std::vector<std::pair<glm::dvec2, glm::dvec2>> lines;
    std::multiset<Line> drawn;
    const auto index_of = [&](glm::dvec2 p) {
        std::size_t best = 0;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const auto off = [&](std::size_t k) {
                return glm::distance(p, glm::dvec2(dots.x[k], dots.y[k]) * kStrokePage.mm_per_page_unit);
            };
            if (off(i) < off(best)) best = i;
        }
        return best;
    };
    for_each_line_of(strokes, [&](glm::dvec2 a, glm::dvec2 b) {
        lines.emplace_back(a, b);
        drawn.insert(std::minmax(index_of(a), index_of(b)));
    });
    // But for lines that lead to none of the 8 nearest, from either end.
    const auto is_near = [&](std::size_t a, std::size_t b) {
        int nearer = 0;
        for (std::size_t c = 0; c < dots.size(); ++c) nearer += c != a && apart(a, c) < apart(a, b);
        return nearer < 8;
    };
    const std::size_t all = graph.size();
    std::erase_if(graph, [&](Line line) {
        return !is_near(line.first, line.second) && !is_near(line.second, line.first);
    });
    CHECK(std::multiset<Line>(graph.begin(), graph.end()) == drawn);
    CHECK(graph.size() > 0.99 * static_cast<double>(all));
    int crossings = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            crossings += cross(lines[i].first, lines[i].second, lines[k].first, lines[k].second);
    CHECK(crossings == 0);
    // Fewer than a stroke a line: about half of the dots where an odd number of lines meet begin one.
    CHECK(strokes.ends.size() < lines.size() / 2);
}

TEST_CASE("a spiral and a hatch fill their dot, and no shape but a path reaches over its rim") {
    const double radius = 2, pen = 0.3, dpi = 1270;  // 50 pixels to the millimetre
    const PageSize page{.width_mm = 5, .height_mm = 5, .mm_per_page_unit = 5};
    Dots dot;
    dot.x.push_back(0.5f);
    dot.y.push_back(0.5f);
    const RasterRequest request{.dpi = dpi};
    const Grid<float> disc =
        coverage_of({.size = page, .dots = stream_of(dot), .dot_radius_mm = radius}, request);
    for (const char* name : {"point", "stroke", "spiral", "hatch", "ring", "cross"}) {
        CAPTURE(name);
        const DotMark mark = parse_dot_mark(name);
        const Grid<float> drawn = coverage_of(
            {.size = page, .strokes = marks_of(stream_of(dot), page, mark, radius, pen)}, request);
        double of_disc = 0, inside = 0, outside = 0;
        for (std::size_t i = 0; i < disc.values.size(); ++i) {
            of_disc += disc.values[i];
            inside += std::min(disc.values[i], drawn.values[i]);
            outside += std::max(drawn.values[i] - disc.values[i], 0.0f);
        }
        CHECK(outside < 0.001 * of_disc);
        const bool fills = mark.shape == DotShape::spiral || mark.shape == DotShape::hatch;
        if (fills) CHECK(inside > 0.99 * of_disc);
        const double ring = 1 - std::pow((radius - pen) / radius, 2);
        if (mark.shape == DotShape::ring) CHECK(inside / of_disc == doctest::Approx(ring).epsilon(0.01));
        if (mark.shape == DotShape::point)
            CHECK(inside / of_disc == doctest::Approx(std::pow(pen / 2 / radius, 2)).epsilon(0.01));
        // Wider than the dot: a touch.
        CHECK(mark_of(mark, radius, 2 * radius).points.size() == 1);
    }
}

TEST_CASE("a path of one's own is read strictly, and its curves are where their formulas say") {
    const Strokes quarter = parse_dot_path("M1,.5A.5,.5 0 0 1 .5,1");  // of the circle in the box
    for (const glm::dvec2 p : quarter.points) {
        CHECK(glm::distance(p, {0.5, 0.5}) == doctest::Approx(0.5));
        CHECK(std::min(p.x, p.y) > 0.5 - 1e-9);
    }
    CHECK(length_of(quarter) == doctest::Approx(std::numbers::pi / 4).epsilon(0.001));
    CHECK(length_of(parse_dot_path("M.9 .5 A.4,.4 0 1 1 .5 .1")) ==
          doctest::Approx(0.4 * 1.5 * std::numbers::pi).epsilon(0.002));
    const Strokes cubic = parse_dot_path("M0,0 C0,1 1,1 1,0");
    CHECK(glm::distance(cubic.points[12], {0.5, 0.75}) < 1e-12);  // of its 24 lines the middle
    const Strokes square = parse_dot_path("M0 0H1V1L0,1Z M.5 .5 1 .5");
    CHECK(square.ends == std::vector<std::size_t>{5, 7});
    CHECK(length_of(square) == doctest::Approx(4.5));
    CHECK(parse_dot_path("M0,0 Q0.5,1 1,0").points[12].y == doctest::Approx(0.5));

    CHECK(complaint_about_mark("blob").starts_with("'blob' is not known; there are circle, point"));
    CHECK(complaint_about_mark("M0,0 L2,1").find("reaches to 2,1") != std::string::npos);
    CHECK(complaint_about_mark("M0,0 l1,1").find("'l' is not known") != std::string::npos);
    CHECK(complaint_about_mark("M0,0 L1").find("after L there has to be a number") != std::string::npos);
    CHECK(complaint_about_mark("M0,0 L1,1e99999").find("a number") != std::string::npos);
    CHECK(complaint_about_mark("M0,0 A1,1 0 2 0 1,1").find("flag") != std::string::npos);
    CHECK(complaint_about_mark("M").find("a number") != std::string::npos);
    // What a machine would be sent far away by.
    for (const char* const hostile :
         {"M0,0 A1e-200,1e-200 0 0 1 1,1", "M0,0 A1e-9,1 0 0 1 1,1", "M0,0 A1,1 1e300 0 1 2,2"})
        CHECK(complaint_about_mark(hostile).find("the path 'M0,0 A1") == 0);
    for (const char* const hostile :
         {"M0,0 C1e308,1e308 -1e308,-1e308 1,1", "M0,0 Q1e308,0 1,1 Q-1e308,0 0,0"})
        CHECK(complaint_about_mark(hostile).find("its box is from 0,0 to 1,1") != std::string::npos);
    for (const glm::dvec2 p :
         parse_dot_path("M.5,.5 A1,1 0 0 1 .5,.5000000001 A1e-6,1e-6 30 1 0 .4,.4").points)
        CHECK((p.x >= -1e-6 && p.x <= 1 + 1e-6 && p.y >= -1e-6 && p.y <= 1 + 1e-6));
    CHECK(text_of(parse_dot_mark("M0,0 L1,1")) == "M0,0 L1,1");
}

TEST_CASE("pixels of strokes are what lies within half a pen of them") {
    const Strokes strokes = some_strokes();
    const double width = 0.5, dpi = 50.8;  // 2 pixels to the millimetre
    RasterRequest request{.dpi = dpi};
    const Grid<float> drawn =
        coverage_of({.size = kStrokePage, .strokes = stream_of(strokes, width)}, request);
    REQUIRE(drawn.width == 80);
    REQUIRE(drawn.height == 60);
    double most = 0;
    for (int y = 0; y < drawn.height; y += 3) {
        for (int x = 0; x < drawn.width; x += 3) {
            int covered = 0;
            for (int k = 0; k < 256; ++k) {
                const glm::dvec2 p((x + (k % 16 + 0.5) / 16) / 2, (y + (k / 16 + 0.5) / 16) / 2);
                double nearest = 1e9;
                stream_of(strokes, width).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
                    for (std::size_t i = 0; i < points.size(); ++i)
                        nearest = std::min(nearest, distance_to_line(p, points[i ? i - 1 : 0], points[i]));
                });
                covered += nearest <= width / 2;
            }
            most = std::max(most, std::abs(double(drawn.at(x, y)) - covered / 256.0));
        }
    }
    CHECK(most < 1.5 / 256);  // a sample that lies just on the rim
    request.dots_at_once = 10;
    CHECK(coverage_of({.size = kStrokePage, .strokes = stream_of(strokes, width)}, request).values ==
          drawn.values);
}

TEST_CASE("machines that read strokes draw them, and touch the paper where a stroke is a point") {
    const Strokes strokes = some_strokes();
    std::vector<std::vector<glm::dvec2>> lines;
    std::vector<glm::dvec2> touches;
    stream_of(strokes, 0.4).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
        std::vector<glm::dvec2> up;
        for (const glm::dvec2 p : points) up.emplace_back(p.x, kStrokePage.height_mm - p.y);
        if (up.size() == 1)
            touches.push_back(up[0]);
        else
            lines.push_back(up);
    });
    const auto check = [&](const Plotted& plot, double rounding) {
        REQUIRE(plot.lines.size() == lines.size());
        double most = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            REQUIRE(plot.lines[i].size() == lines[i].size());
            for (std::size_t k = 0; k < lines[i].size(); ++k)
                most = std::max(most, glm::distance(plot.lines[i][k], lines[i][k]));
        }
        CHECK(most < rounding);
        REQUIRE(plot.dots.size() >= touches.size());
    };
    for (const GcodeTool tool : {GcodeTool::pen, GcodeTool::servo, GcodeTool::laser}) {
        CAPTURE(name_of(tool));
        std::ostringstream out;
        write_gcode(out, {.size = kStrokePage,
                          .strokes = stream_of(strokes, 0.4),
                          .gcode = GcodeStyle{.lines = parse_gcode_template(gcode_template_of(tool)),
                                              .heights = usual_heights(tool)}});
        check(plotted_gcode(out.str(), Lines::drawn), 0.00075);
    }
    std::ostringstream hpgl;
    write_hpgl(hpgl, {.size = kStrokePage, .strokes = stream_of(strokes, 0.4)});
    const Plotted plot = plotted_hpgl(hpgl.str(), Lines::drawn);
    check(plot, 0.018);
    REQUIRE(plot.dots.size() == touches.size());
    CHECK(glm::distance(plot.dots[1], touches[1]) < 0.018);
    std::ostringstream dxf;
    write_dxf(dxf, {.size = kStrokePage, .strokes = stream_of(strokes, 0.4)});
    const auto count = [text = dxf.str()](const std::string& what) {
        std::size_t found = 0;
        for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
        return found;
    };
    CHECK(count("\nLWPOLYLINE\n") == lines.size());
    CHECK(count("\nPOINT\n") == touches.size());
    const GcodeTemplate only_dots = parse_gcode_template("start G21\nmove G1 X{x} Y{y}\ndot G4 P{dwell}\n");
    const InkPage lines_by_dots{
        .size = kStrokePage, .strokes = stream_of(strokes, 0.4), .gcode = GcodeStyle{.lines = only_dots}};
    CHECK_THROWS_WITH(write_gcode(dxf, lines_by_dots), doctest::Contains("does not say how to draw lines"));
}

TEST_CASE("parts of a page have all of its lines, and nothing beyond their edges") {
    const Strokes strokes = some_strokes();
    double length = 0;
    std::size_t touches = 0;
    for (int i = 0; i < 6; ++i) {
        const glm::dvec2 low(i % 3 * 40.0 / 3, i / 3 * 15.0), size(40.0 / 3, 15);
        const Strokes part = cut_to({low, low + size}, stream_of(strokes, 0.4));
        length += length_of(part);
        for (const glm::dvec2 p : part.points) {
            CHECK(std::min(p.x, p.y) >= 0);
            CHECK(std::max(p.x - size.x, p.y - size.y) <= 0);
        }
        std::size_t begin = 0;
        for (const std::size_t end : part.ends) touches += end - std::exchange(begin, end) == 1;
    }
    CHECK(length == doctest::Approx(length_of(strokes)));
    CHECK(touches == 2);
}

TEST_CASE("figures of strokes are those of their lines and of the moves between them") {
    Strokes two = line_through(random_dots(2, 1), kStrokePage);
    two.points.emplace_back(3, 4);
    end_stroke(two);
    const StrokeFigures figures = figures_of(stream_of(two, 0.3), program_of(Machine::axidraw_v3));
    CHECK(figures.strokes == 2);
    CHECK(figures.segments == 1);
    CHECK(figures.drawn_m == doctest::Approx(glm::distance(two.points[0], two.points[1]) / 1000));
    CHECK(figures.longest_mm == doctest::Approx(glm::distance(two.points[0], two.points[1])));
    CHECK(figures.pen_up_m == doctest::Approx(glm::distance(two.points[1], two.points[2]) / 1000));
}

}  // namespace dapple
