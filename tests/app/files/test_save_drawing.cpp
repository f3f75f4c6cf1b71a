// Saving a drawing while someone watches it.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/files/save_drawing.h"
#include "core/drawing/gcode_choice.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

Dots many_dots() {
    Dots dots;
    for (int i = 0; i < 150'000; ++i) {
        dots.x.push_back(static_cast<float>(i % 500) / 500);
        dots.y.push_back(static_cast<float>(i / 500) / 300);
        dots.threshold.push_back(0.5f);
        dots.critical.push_back(1);
    }
    return dots;
}

// A strip of the dots, with several bands of pixels.
constexpr PageSize kPage{.width_mm = 10, .height_mm = 100, .mm_per_page_unit = 100};

// As they come: another order would have to be found first.
DrawingToSave many_to_save(const Dots& dots) {
    return {.dots = stream_of(dots, 100), .page = kPage, .saving = {.order = DotOrder::recursion}};
}

}  // namespace

TEST_CASE("no number leaves for a machine that is none, or lies far from the page") {
    const TemporaryFolder folder;
    const fs::path file = folder / "drawing";
    put_text(file, "the old drawing");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    // Page units are 100 mm; dots that reach over from beside a small part of a page are not far.
    const auto saved = [&](DrawingFormat format, float x, float y, float radius, bool as_stroke) {
        Dots dots;
        dots.x = {0.05f, x};
        dots.y = {0.5f, y};
        dots.radius = {0.01f, radius};
        dots.threshold = {0.5f, 0.5f};
        dots.critical = {1, 1};
        DrawingToSave drawing = many_to_save(dots);
        drawing.format = format;
        Strokes strokes{.points = {{1, 1}, {100.0 * x, 100.0 * y}}, .ends = {2}};
        if (as_stroke) drawing.strokes = stream_of(strokes, 0.3);
        try {
            return save_drawing(file, {}, drawing);
        } catch (const std::runtime_error& error) {
            CHECK(std::string(error.what()).find("far from its page") != std::string::npos);
            CHECK(text_of(file) == "the old drawing");
            return false;
        }
    };
    for (const DrawingFormatName& format : kDrawingFormats) {
        if (has_pixels(format.format)) continue;
        for (const bool as_stroke : {false, true}) {
            if (as_stroke && is_table(format.format)) continue;
            CAPTURE(std::string(format.word));
            CAPTURE(as_stroke);
            for (const float wrong : {nan, INFINITY, -INFINITY, 9e12f, -9e12f, 4.0f}) {
                CHECK_FALSE(saved(format.format, wrong, 0.5f, 0.01f, as_stroke));
                CHECK_FALSE(saved(format.format, 0.05f, wrong, 0.01f, as_stroke));
                if (!as_stroke && format.format != DrawingFormat::hpgl)
                    CHECK_FALSE(saved(format.format, 0.05f, 0.5f, wrong + 1, false));
            }
            CHECK(saved(format.format, -0.3f, 1.3f, 0.3f, as_stroke));
            put_text(file, "the old drawing");
        }
    }
}

TEST_CASE("the time of G-code is that of its feed, its rests and the machine's acceleration, as by hand") {
    Dots dots;  // two moves of 100 mm
    for (const float x : {0.0f, 0.5f, 1.0f}) {
        dots.x.push_back(x);
        dots.y.push_back(0);
    }
    SavingChoice saving{.feed_mm_per_min = 6000, .dwell_s = 2, .acceleration_mm_per_s2 = 1000};
    const auto time = [&](DrawingFormat format = DrawingFormat::gcode) {
        return plotting_time(dots, 200, speeds_for(usual_machine(format, saving.tool), format, saving));
    };
    // 100 mm/s after a tenth of a second and before another: 10 mm are lost.
    const double moves_s = 2 * (100 / 100.0 + 0.1), lift_s = 2 * std::sqrt(2 / 1000.0);
    saving.tool = GcodeTool::laser;
    CHECK(time().moving_s == doctest::Approx(moves_s));
    CHECK(time().dots_s == 3 * 2);
    CHECK(time().lifting_s == 0);
    saving.tool = GcodeTool::servo;  // which turns twice
    CHECK(time().total_s() == doctest::Approx(moves_s + 3 * 2 * 2));
    saving.tool = GcodeTool::pen;  // up and down by 2 mm
    CHECK(time().total_s() == doctest::Approx(moves_s + 3 * (2 + 2 * lift_s)));
    saving.pen_up = 7;
    saving.pen_down = -1;
    CHECK(time().lifting_s == doctest::Approx(3 * 2 * 2 * std::sqrt(8 / 1000.0)));
    saving.gcode_template.text = "move G1 X{x} Y{y}\ndot G4 P{dwell}\ndot G4 P{dwell}\ndot G4 P{dwell}\n";
    CHECK(time().dots_s == 3 * 3 * 2);
    // Grbl rounds each G4 up to 0.05 s, and knows no other word of a template's.
    saving.dwell_s = 0.01;
    CHECK(time().dots_s == doctest::Approx(3 * 3 * 0.05));
    saving.gcode_template.text = "move G1 X{x} Y{y}\ndot M10 P{dwell}\n";
    CHECK(time().dots_s == doctest::Approx(3 * 0.01));
    saving.gcode_template.text.clear();
    CHECK(time().dots_s == doctest::Approx(3 * 0.05));
    saving.tool = GcodeTool::servo;
    CHECK(time().lifting_s == doctest::Approx(3 * 2 * 0.05));
    // A laser moves by 0.05 mm: at 5 mm/s, for which 1000 mm/s2 take 0.005 s, and as long to stop.
    saving.tool = GcodeTool::laser;
    CHECK(time().dots_s == doctest::Approx(3 * (0.05 / 5 + 0.005)));
    saving.dwell_s = 0.12;
    CHECK(time().dots_s == doctest::Approx(3 * 0.15));
    // What is no G-code goes as the machine's own program has it.
    CHECK(time(DrawingFormat::svg) == plotting_time(dots, 200, speeds_of(Machine::axidraw_v3)));
}

TEST_CASE("progress rises from nothing to all, in every format") {
    TemporaryFolder folder;
    const Dots dots = many_dots();
    for (const char* name :
         {"a.svg", "a.csv", "a.png", "a.pdf", "a.tif", "a.gcode", "a.hpgl", "a.dxf", "a.json"}) {
        CAPTURE(name);
        std::vector<double> shares;
        const SavingWatch watch{.stop = {}, .progress = [&](double share) { shares.push_back(share); }};
        CHECK(save_drawing(folder / name, {}, many_to_save(dots), watch));
        REQUIRE(shares.size() > 3);
        CHECK(shares.front() == 0);
        CHECK(shares.back() == 1);
        for (std::size_t i = 1; i < shares.size(); ++i) CHECK(shares[i] >= shares[i - 1]);
    }
}

TEST_CASE("a saving that is stopped half way leaves the old file whole and nothing else") {
    TemporaryFolder folder;
    const Dots dots = many_dots();
    for (const char* name :
         {"a.svg", "a.csv", "a.png", "a.pdf", "a.tif", "a.gcode", "a.hpgl", "a.dxf", "a.json"}) {
        CAPTURE(name);
        std::ofstream(folder / name) << "old";
        std::stop_source source;
        const auto stop_half_way = [&](double share) {
            if (share > 0.4) source.request_stop();
        };
        CHECK_FALSE(save_drawing(folder / name, {}, many_to_save(dots),
                                 {.stop = source.get_token(), .progress = stop_half_way}));
        CHECK(text_of(folder / name) == "old");
        fs::remove(folder / name);
        CHECK(fs::is_empty(folder / "."));
    }
}

TEST_CASE("a PDF most of whose dots lie beyond its page is stopped wherever it has come to") {
    TemporaryFolder folder;
    Dots dots;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(0, 1);
    for (int i = 0; i < 60'000; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(static_cast<float>(i) / 60'000);  // whole paths of theirs are left out
    }
    DrawingToSave drawing = many_to_save(dots);
    drawing.page = {.width_mm = 100, .height_mm = 20, .mm_per_page_unit = 100};
    for (const double at : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        CAPTURE(at);
        std::stop_source source;
        const auto stop_there = [&](double share) {
            if (share > at) source.request_stop();
        };
        CHECK_FALSE(save_drawing(folder / "a.pdf", {}, drawing,
                                 {.stop = source.get_token(), .progress = stop_there}));
        CHECK(fs::is_empty(folder / "."));
    }
}

TEST_CASE(
    "up to a million dots are saved for plotters in an order of short moves, unless another is asked for") {
    const Dots dots = many_dots();
    CHECK(usual_order(DrawingFormat::svg, 1'000'000) == DotOrder::shortest);
    CHECK(usual_order(DrawingFormat::svg, kMostRoutedDots + 1) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::svg, kMostSortedDots + 1) == DotOrder::recursion);
    CHECK(usual_order(DrawingFormat::gcode, kMostRoutedDots + 1) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::csv, 10) == DotOrder::recursion);
    TemporaryFolder folder;
    Dots few = dots;
    few.resize(3'000, false);
    const auto saved = [&](std::optional<DotOrder> order) {
        CHECK(save_drawing(folder / "a.svg", {},
                           {.dots = stream_of(few, 100), .page = kPage, .saving = {.order = order}}));
        return text_of(folder / "a.svg");
    };
    CHECK(saved({}) == saved(DotOrder::shortest));
    CHECK(saved({}) != saved(DotOrder::recursion));
    // The first dot along a Hilbert curve is the one in the corner, the last the one across.
    const Dots sorted = sorted_dots(stream_of(dots, 100), DotOrder::space);
    CHECK(sorted.size() == dots.size());
    CHECK(sorted.x[0] == 0);
    CHECK(sorted.y[0] == 0);
    CHECK(sorted.x[dots.size() - 1] > 0.99f);
    CHECK(sorted.y[dots.size() - 1] < 0.01f);
}

}  // namespace dapple
