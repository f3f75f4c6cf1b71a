// What the rows of dots do. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/settings_panels.h"
#include "core/settings/setting.h"
#include "core/text/shown_text.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

const std::array<std::string, 2> kTiles{"paper16", "wild64"};

struct DotsUi {
    ViewerSettings all = {};
    DrawingSettings& settings = all.drawing;
    DrawnInfo drawn{.dots = 12'345, .scale = 777, .dot_radius_mm = 0.25};
    HeadlessUi ui{[this] {
        draw_dots_panel(settings, drawn);
        draw_method_rows(all, {kTiles});
    }};
};

}  // namespace

TEST_CASE("going from count to scale and back keeps the drawing") {
    DotsUi f;
    REQUIRE(f.settings.placing.count == kDefaultDots);
    f.ui.click("from tone");
    CHECK_FALSE(f.settings.placing.count);
    CHECK(f.settings.placing.scale == 777);
    f.ui.click("as set");
    CHECK(f.settings.placing.count == 12'345);
}

TEST_CASE("the scale slider is logarithmic") {
    DotsUi f;
    f.ui.click("from tone");
    f.ui.drag("Dots in black", 0.3f, 0.5f);
    CHECK(f.settings.placing.scale == doctest::Approx(1000).epsilon(0.05));
    f.ui.drag("Dots in black", 0.5f, 1.0f);
    CHECK(f.settings.placing.scale == 100'000);
}

TEST_CASE("the dots in black are so many on a square centimetre, or on a square inch") {
    DrawingSettings settings;
    settings.placing.count.reset();
    LengthUnit unit = LengthUnit::mm;
    HeadlessUi ui([&] { draw_dots_panel(settings, {.page = {400, 300, 400}}, unit); });
    // At the scale of 2500 there are 40,000 of them in a square as wide as the page.
    ui.enter("Dots in black", "25");
    CHECK(settings.placing.scale == doctest::Approx(2500));
    unit = LengthUnit::inch;
    ui.frame();
    ui.enter("Dots in black", "25*2.54*2.54");
    CHECK(settings.placing.scale == doctest::Approx(2500));
    ui.double_click("Dots in black name");
    CHECK(settings.placing.scale == doctest::Approx(setting::scale.usual));
}

TEST_CASE("the count slider gives whole numbers") {
    DotsUi f;
    f.ui.drag("Dots", 0.2f, 1.0f);
    CHECK(f.settings.placing.count == 2'000'000);
    f.ui.drag("Dots", 0.9f, 0.0f);
    CHECK(f.settings.placing.count == 100);
}

TEST_CASE("a typed count is at most what fits into memory, and the panel says why") {
    DotsUi f;
    f.drawn.most_dots = 7'654'321;
    f.ui.frame();
    f.ui.enter("Dots", "7,654,322");
    CHECK(f.settings.placing.count == kDefaultDots);
    CHECK(f.ui.has("Refusal"));
    f.ui.enter("Dots", "7,654,321");
    CHECK(f.settings.placing.count == 7'654'321);
    f.ui.enter("Dots", "3G");
    f.ui.move_to({1, 899});
    f.ui.frame(5);
    CHECK_FALSE(f.ui.has("Tip"));
    f.ui.move_to(f.ui.at("Dots", 0.3f));
    f.ui.frame(1);
    CHECK(f.ui.has("Tip"));
    // Nothing moves beneath the pointer when there are that many.
    const WidgetPlace below = f.ui.place("Relax");
    f.drawn.dots = 7'654'321;
    f.ui.frame();
    CHECK(f.ui.place("Relax") == below);
}

TEST_CASE("a typed scale is at most the one whose dots fit into memory") {
    DotsUi f;
    f.drawn.most_dots = 1'234'500;  // a hundred times as many as are drawn
    f.ui.click("from tone");
    f.ui.enter("Dots in black", "99999999999");
    CHECK(f.settings.placing.scale == doctest::Approx(77'700).epsilon(1e-9));
    f.ui.drag("Dots in black", 0.5f, 1.0f);
    CHECK(f.settings.placing.scale == doctest::Approx(77'700).epsilon(1e-9));
}

TEST_CASE("no value is so long that it reaches over its slider's track") {
    DotsUi f;
    for (const std::uint64_t count : {2'000'000ull, 1'000'000'000ull}) {
        f.settings.placing.count = count;
        f.ui.frame();
        const WidgetPlace value = f.ui.place("Dots value"), track = f.ui.place("Dots");
        CHECK(value.min.x >= track.max.x);
        CHECK(value.max.x - value.min.x > ImGui::CalcTextSize(grouped(count).c_str()).x);
        CHECK(track.max.x - track.min.x > 60);
    }
}

TEST_CASE("a look at Figure 8 and back leaves everything as it was") {
    DotsUi f;
    const DrawingSettings before = f.settings;
    f.ui.click("Figure 8");
    CHECK(f.settings.placer == PlacerKind::figure8);
    CHECK(f.settings.placing.count == before.placing.count);
    CHECK(tile_in_use(f.settings) == "paper16");
    f.ui.click("exact");
    CHECK(f.settings == before);
}

TEST_CASE("what Figure 8 does not know is not there, and a list of all rows says why") {
    DotsUi f;
    CHECK(f.ui.has("Relax"));
    CHECK(f.ui.has("Ranking"));
    f.ui.click("Figure 8");
    f.ui.frame();
    CHECK_FALSE(f.ui.has("Relax"));
    CHECK_FALSE(f.ui.has("Ranking"));
    std::vector<ListedRow> rows;
    ImGui::NewFrame();
    {
        const RowListing listing(rows);
        draw_dots_panel(f.settings, f.drawn);
    }
    ImGui::EndFrame();
    const auto row = std::ranges::find(rows, "Relax", &ListedRow::label);
    REQUIRE(row != rows.end());
    CHECK(row->why_not == why_only_exact(PlacerKind::figure8));
}

TEST_CASE("what is typed may be 40k or 8in, and what cannot be is said") {
    DotsUi f;
    f.ui.enter("Dots", "40k");
    CHECK(f.settings.placing.count == 40'000);
    CHECK_FALSE(f.ui.has("Refusal"));
    // As the command refuses it.
    for (const char* const wrong : {"0", "-5", "1e13", "2,5", "10.000", "1.5", "40 thousand", "many"}) {
        CAPTURE(wrong);
        f.ui.enter("Dots", wrong);
        CHECK(f.settings.placing.count == 40'000);
        CHECK(f.ui.has("Refusal"));
        f.ui.frame(5);
        f.ui.frame();
        CHECK_FALSE(f.ui.has("Refusal"));
    }
    f.ui.enter("Relax", "2.5");
    CHECK_FALSE(f.settings.relax);
    CHECK(f.ui.has("Refusal"));
}

TEST_CASE("a fixed dot size begins at the one on screen") {
    DotsUi f;
    CHECK_FALSE(f.ui.has("Radius, mm"));
    f.ui.click("fixed");
    CHECK(f.settings.dot_size.sizing == DotSizing::fixed);
    CHECK(f.settings.dot_size.radius_mm == 0.25);
    f.ui.drag("Radius, mm", 0.5f, 1.0f);
    CHECK(f.settings.dot_size.radius_mm == 5);
    f.ui.click("auto");
    CHECK(f.settings.dot_size.sizing == DotSizing::automatic);
    CHECK_FALSE(f.ui.has("Radius, mm"));
}

TEST_CASE("dots sized by tone have two radii that never cross, and no count of their own") {
    DotsUi f;
    f.ui.click("by tone");
    CHECK(f.settings.dot_size.sizing == DotSizing::by_tone);
    const std::optional<std::uint64_t> count = f.settings.placing.count;
    f.ui.drag("Dots", 0.5f, 1.0f);
    CHECK(f.settings.placing.count == count);  // greyed, and says why
    f.ui.frame(1);
    CHECK(f.ui.has("Tip"));
    f.ui.drag("Smallest, mm", 0.5f, 1.0f);
    CHECK(f.settings.dot_size.largest_mm >= f.settings.dot_size.smallest_mm);
    f.ui.drag("Largest, mm", 1.0f, 0.0f);
    CHECK(f.settings.dot_size.smallest_mm <= f.settings.dot_size.largest_mm);
    CHECK(f.settings.dot_size.largest_mm < 0.03);
}

TEST_CASE("the relax row shows the usual steps until it is moved, and brought back they are automatic") {
    DotsUi f;
    f.drawn.steps = f.drawn.usual_steps = 14;
    f.ui.frame();
    CHECK_FALSE(f.settings.relax);
    f.ui.enter("Relax", "5");
    CHECK(f.settings.relax == 5);
    f.ui.enter("Relax", "14");
    CHECK_FALSE(f.settings.relax);
    f.ui.drag("Relax", 0.2f, 1.0f);
    CHECK(f.settings.relax == 20);
    f.ui.drag("Relax", 1.0f, 0.0f);
    CHECK(f.settings.relax == 0);
}

TEST_CASE("another tile and ranking can be chosen from their lists") {
    DotsUi f;
    f.ui.click("Tile");
    f.ui.click("wild64");
    CHECK(f.settings.tile == "wild64");
    f.ui.click("Ranking");
    f.ui.click("farthest point");
    CHECK(f.settings.ranking == RankingMethod::farthest);
}

TEST_CASE("dots are drawn as lines or in another shape by the pen whose width is typed") {
    DrawingSettings drawing;
    HeadlessUi ui([&] { draw_dots_panel(drawing, {}); });
    ui.click("Dot shape");
    ui.click("spiral");
    CHECK(drawing.mark.shape == DotShape::spiral);
    ui.enter("Pen width, mm", "0.5");
    CHECK(drawing.pen_width_mm == 0.5);
    ui.click("one line");
    CHECK(drawing.style == DrawingStyle::line);
    ui.click("network");
    CHECK(drawing.style == DrawingStyle::nearest);
    ui.click("dots");
    CHECK(drawing.style == DrawingStyle::dots);
}

TEST_CASE("a dot's own path is typed: what is none is told and changes nothing") {
    DrawingSettings drawing;
    drawing.mark.shape = DotShape::path;
    drawing.mark.path = "M0,0 L1,1";
    HeadlessUi ui([&] { draw_dots_panel(drawing, {}); });
    ui.click("Custom path");
    ui.key(Key::end);
    ui.type(" L9,9");
    CHECK(drawing.mark.path == "M0,0 L1,1");
    CHECK(ui.has("Refusal"));
    for (int i = 0; i < 3; ++i) ui.key(Key::backspace);
    ui.type("1,0");
    CHECK(drawing.mark.path == "M0,0 L1,1 L1,0");
    CHECK_FALSE(ui.has("Refusal"));
}

}  // namespace dapple
