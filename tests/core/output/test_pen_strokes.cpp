// Lines and shapes of several pens: each in its own colour, width and layer, after one change to it.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <pugixml.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/output/drawing_format.h"
#include "core/output/pen_figures.h"
#include "core/output/raster.h"
#include "core/strokes/dot_shape.h"
#include "core/strokes/drawing_style.h"
#include "tests/machines.h"

namespace dapple {
namespace {

constexpr PageSize kPensPage{.width_mm = 60, .height_mm = 40, .mm_per_page_unit = 60};

const Palette kTwoPens{{"Sand", {0.9f, 0.8f, 0.3f}, 0.4, 0.9}, {"Night", {0.1f, 0.1f, 0.3f}, 0.2, 0}};

DotPieces dots_of_two_pens() {
    DotPieces dots;
    std::mt19937 random(17);
    std::uniform_real_distribution<float> across(0.1f, 0.9f), down(0.1f, 0.5f);
    for (int pen = 0; pen < 2; ++pen) {
        Dots& own = dots.pieces.emplace_back();
        own.pen = pen;
        for (int i = 0; i < 60; ++i) {
            own.x.push_back(across(random));
            own.y.push_back(down(random));
        }
    }
    return dots;
}

StrokeStream crosses_of(const DotPieces& dots) {
    return marks_of(stream_of(dots), kPensPage, {DotShape::cross, {}}, 0.8, 0.3, {0.4, 0.2});
}

// One pen's strokes as machines count them: from the lower left corner.
std::vector<std::vector<glm::dvec2>> turned_strokes(const StrokeStream& strokes, int pen) {
    std::vector<std::vector<glm::dvec2>> all;
    only(strokes, pen).for_each_stroke([&](std::span<const glm::dvec2> points, int its_pen) {
        CHECK(its_pen == pen);
        all.emplace_back();
        for (const glm::dvec2 p : points) all.back().emplace_back(p.x, kPensPage.height_mm - p.y);
    });
    return all;
}

}  // namespace

TEST_CASE("a mark is as wide as its own pen lets it be, and a line goes through one pen's dots alone") {
    const DotPieces dots = dots_of_two_pens();
    const StrokeStream crosses = crosses_of(dots);
    std::map<int, double> longest;
    crosses.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        longest[pen] = std::max(longest[pen], glm::distance(points[0], points[1]));
    });
    // The ink ends at the dot's rim.
    CHECK(longest[0] == doctest::Approx(2 * 0.8 - 0.4));
    CHECK(longest[1] == doctest::Approx(2 * 0.8 - 0.2));
    CHECK(crosses.widest() == 0.4);

    const Strokes line = line_through(dots.pieces[1], kPensPage);
    CHECK(pen_of(line, 0) == 1);
    Strokes both = line_through(dots.pieces[0], kPensPage);
    append(both, line);
    CHECK(both.points.size() == 120);
    CHECK(both.ends == std::vector<std::size_t>{60, 120});
    CHECK(both.pens == std::vector<int>{0, 1});
    CHECK(collected(stream_of(both, 1)) == both);
    CHECK(collected(only(stream_of(both, 1), 1)).points == line.points);
}

TEST_CASE(
    "each pen that has dots is taken once and draws its marks before them; a single one is always there") {
    // "pen 1", "line", "dot": what a format is handed.
    class Recorder : public InkWriter {
     public:
        std::vector<std::string> taken;

     private:
        void begin_pen(int number, const Pen& pen, double) override {
            taken.push_back(pen.name + ' ' + std::to_string(number));
        }
        void dot(const InkDot&) override { taken.emplace_back("dot"); }
        void stroke(std::span<const glm::dvec2>) override { taken.emplace_back("line"); }
        void end() override { taken.emplace_back("end"); }
    };
    const auto written = [](const InkPage& page) {
        Recorder recorder;
        write_ink(recorder, page);
        return recorder.taken;
    };
    // Its empty pieces too.
    const auto all_of = [](const DotPieces& dots) -> DotStream {
        return {dots.size(), 0, 0, [&dots](const TakePiece& take) {
                    for (const Dots& piece : dots.pieces) take(piece);
                }};
    };
    Dots two;
    two.x = two.y = {0.25f, 0.5f};
    Dots one = two;
    one.resize(1, false);
    one.pen = 1;
    Dots none;
    none.pen = 1;
    const DotPieces sand{{none, two, two}}, both{{two, none, one, one}};
    InkPage page{.size = kPensPage, .dots = all_of(sand), .pens = kTwoPens};
    CHECK(written(page) == std::vector<std::string>{"Sand 0", "dot", "dot", "dot", "dot", "end"});
    page.dots = all_of(both);
    page.registration = {{{1, 1}, {2, 1}}, {{1, 1}, {1, 2}}};
    CHECK(written(page) == std::vector<std::string>{"Sand 0", "line", "line", "dot", "dot", "Night 1", "line",
                                                    "line", "dot", "dot", "end"});
    CHECK(written({.size = kPensPage}) == std::vector<std::string>{"Black 0", "end"});
}

TEST_CASE("machines change the pen once for each, draw its registration marks and then its strokes") {
    const DotPieces dots = dots_of_two_pens();
    const StrokeStream crosses = crosses_of(dots);
    const std::vector<CutMark> marks = registration_marks(kPensPage);
    REQUIRE(marks.size() == 8);
    InkPage page{.size = kPensPage, .strokes = crosses, .pens = kTwoPens, .registration = marks};
    const auto check = [&](const std::vector<std::vector<glm::dvec2>>& drawn, double rounding) {
        std::vector<std::vector<glm::dvec2>> wanted;
        for (int pen = 0; pen < 2; ++pen) {
            for (const CutMark& mark : marks)
                wanted.push_back({{mark.from.x, 40 - mark.from.y}, {mark.to.x, 40 - mark.to.y}});
            for (const auto& stroke : turned_strokes(crosses, pen)) wanted.push_back(stroke);
        }
        REQUIRE(drawn.size() == wanted.size());
        double most = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            REQUIRE(drawn[i].size() == 2);
            for (int end = 0; end < 2; ++end)
                most = std::max(most, glm::distance(drawn[i][end], wanted[i][end]));
        }
        CHECK(most < rounding);
    };
    for (const GcodeTool tool : {GcodeTool::pen, GcodeTool::servo, GcodeTool::laser}) {
        page.gcode = {.lines = parse_gcode_template(gcode_template_of(tool)), .heights = usual_heights(tool)};
        std::ostringstream gcode;
        write_gcode(gcode, page);
        const Plotted plot = plotted_gcode(gcode.str(), Lines::drawn);
        check(plot.lines, 0.00075);
        REQUIRE(plot.changes.size() == 2);
        CHECK(plot.changes[0].pen == "1 Sand");
        CHECK(plot.changes[1].pen == "2 Night");
    }
    std::ostringstream hpgl;
    write_hpgl(hpgl, page);
    const Plotted plot = plotted_hpgl(hpgl.str(), Lines::drawn);
    check(plot.lines, 0.018);
    CHECK(plot.changes.size() == 2);
}

TEST_CASE("an SVG has a layer for each pen, in its colour and as wide as it is, with its marks and strokes") {
    const DotPieces dots = dots_of_two_pens();
    const std::vector<CutMark> marks = registration_marks(kPensPage);
    std::ostringstream out;
    write_svg(out, {.size = kPensPage, .strokes = crosses_of(dots), .pens = kTwoPens, .registration = marks});
    pugi::xml_document document;
    REQUIRE(document.load_string(out.str().c_str()));
    std::vector<pugi::xml_node> layers;
    for (const pugi::xml_node& layer : document.child("svg").children("g")) layers.push_back(layer);
    REQUIRE(layers.size() == 2);
    for (std::size_t pen = 0; pen < 2; ++pen) {
        CHECK(layers[pen].attribute("inkscape:label").value() ==
              std::to_string(pen + 1) + ' ' + kTwoPens[pen].name);
        CHECK(layers[pen].attribute("stroke").value() == hex_of(kTwoPens[pen].colour));
        CHECK(layers[pen].attribute("stroke-width").as_double() ==
              doctest::Approx(kTwoPens[pen].width_mm * 96 / 25.4).epsilon(1e-3));
        CHECK(std::distance(layers[pen].children("path").begin(), layers[pen].children("path").end()) ==
              8 + 2 * 60);
    }
    std::ostringstream circles;
    write_svg(circles, {.size = kPensPage, .dots = stream_of(dots), .pens = kTwoPens, .registration = marks});
    REQUIRE(document.load_string(circles.str().c_str()));
    for (const pugi::xml_node& layer : document.child("svg").children("g")) {
        CHECK(std::distance(layer.children("path").begin(), layer.children("path").end()) == 8);
        CHECK(std::distance(layer.children("circle").begin(), layer.children("circle").end()) == 60);
        for (const pugi::xml_node& cross : layer.children("path")) {
            CHECK(cross.attribute("fill").value() == std::string("none"));
            CHECK(cross.attribute("stroke").value() == std::string(layer.attribute("fill").value()));
        }
    }
}

TEST_CASE("a DXF has each pen's strokes and marks on its layer") {
    const DotPieces dots = dots_of_two_pens();
    std::ostringstream dxf;
    write_dxf(dxf, {.size = kPensPage,
                    .strokes = crosses_of(dots),
                    .pens = kTwoPens,
                    .registration = registration_marks(kPensPage)});
    const std::string text = dxf.str();
    const auto count = [&](const std::string& what) {
        std::size_t found = 0;
        for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
        return found;
    };
    for (const char* layer : {"1_Sand", "2_Night"})
        CHECK(count(std::string("\n100\nAcDbEntity\n  8\n") + layer + "\n100\nAcDbPolyline\n") == 8 + 2 * 60);
}

TEST_CASE("each pen's pixels are those of its strokes alone") {
    const DotPieces dots = dots_of_two_pens();
    const StrokeStream crosses = crosses_of(dots);
    const RasterRequest request{.dpi = 100, .threads = 2, .dots_at_once = 40};
    const RasterSize size = raster_size(kPensPage, request.dpi);
    std::vector<Grid<float>> pens(2, Grid<float>(size.width, size.height));
    rasterise({.size = kPensPage, .strokes = crosses, .pens = kTwoPens}, request,
              [&](int first_row, std::span<const Grid<float>> bands) {
                  for (int pen = 0; pen < 2; ++pen)
                      std::ranges::copy(bands[pen].values, pens[pen].row(first_row));
              });
    for (int pen = 0; pen < 2; ++pen) {
        StrokeStream own = only(crosses, pen);
        own.width_mm = kTwoPens[static_cast<std::size_t>(pen)].width_mm;
        own.widths_mm = {};
        CHECK(coverage_of({.size = kPensPage, .strokes = own}, request).values == pens[pen].values);
    }
}

TEST_CASE("figures of each pen are those of its dots, looked at one by one") {
    const DotPieces dots = dots_of_two_pens();
    const std::vector<PenFigures> figures = pen_figures(dots, kPensPage, kTwoPens);
    REQUIRE(figures.size() == 2);
    for (std::size_t pen = 0; pen < 2; ++pen) {
        const Dots& own = dots.pieces[pen];
        double least = std::numeric_limits<double>::infinity(), way = 0;
        std::uint64_t near = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < own.size(); ++k) {
                if (k != i)
                    nearest = std::min(
                        nearest, 60 * std::hypot(double(own.x[i]) - own.x[k], double(own.y[i]) - own.y[k]));
            }
            least = std::min(least, nearest);
            near += nearest < kTwoPens[pen].gap_mm;
            if (i > 0)
                way += 0.06 * std::hypot(double(own.x[i]) - own.x[i - 1], double(own.y[i]) - own.y[i - 1]);
        }
        CHECK(figures[pen].dots == 60);
        CHECK(figures[pen].nearest_mm == doctest::Approx(least));
        CHECK(figures[pen].nearer_than_gap == near);
        CHECK(figures[pen].pen_up_m == doctest::Approx(way));
    }
    CHECK(figures[0].nearer_than_gap > 0);
    CHECK(figures[1].nearer_than_gap == 0);
}

}  // namespace dapple
