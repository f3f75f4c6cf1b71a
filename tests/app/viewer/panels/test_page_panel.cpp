// What the rows of page and crop do. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>

#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/panels/window_panels.h"
#include "tests/headless_ui.h"

namespace dapple {

TEST_CASE("the page is a paper, or as large as is typed, with margins alike or each its own") {
    PageSetup setup;
    Sheet sheets;
    LengthUnit unit = LengthUnit::mm;
    const PageLayout drawn{.page = {200, 150, 200}, .reach_mm = 0.25};
    HeadlessUi ui([&] { draw_page_panel(setup, sheets, drawn, unit); });
    // A page of the picture's shape has no orientation, and one side rules.
    CHECK_FALSE(ui.has("Orientation"));
    ui.enter("Height, mm", "8in");
    CHECK(*setup.height_mm == doctest::Approx(203.2));
    ui.enter("Width, mm", "180");
    CHECK(setup == PageSetup{.width_mm = 180});

    ui.click("Paper size");
    ui.click("A4");
    ui.click("Orientation");
    ui.click("landscape");
    ui.click("fill");
    CHECK_FALSE(ui.has("Width, mm"));  // the paper says it
    ui.enter("Margin, mm", "15");
    CHECK(setup == PageSetup{.paper = Paper::a4,
                             .orientation = PageOrientation::landscape,
                             .width_mm = 180,
                             .margins = Margins{15, 15, 15, 15},
                             .fit = PageFit::fill});
    ui.click("More page settings");
    ui.click("each side");
    ui.enter("Left, mm", "1in");
    CHECK(setup.margins == Margins{15, 15, 15, 25.4});
    ui.click("equal");
    CHECK(setup.margins == Margins{15, 15, 15, 15});
    ui.click("Paper size");
    ui.click("custom");
    CHECK(setup.width_mm == 200);
    CHECK(*setup.height_mm == 150);
    CHECK(setup.orientation == PageOrientation::automatic);
}

TEST_CASE("usual margins are as wide as a dot reaches, stay so when the dots change, and 0 is none") {
    PageSetup setup;
    Sheet sheets;
    PageLayout drawn{.page = {200, 150, 200}, .reach_mm = 0.25};
    HeadlessUi ui([&] { draw_page_panel(setup, sheets, drawn, LengthUnit::mm); });
    ui.enter("Margin, mm", "0");
    CHECK(setup.margins == Margins{});
    ui.enter("Margin, mm", "0.25");
    CHECK_FALSE(setup.margins);
    ui.click("More page settings");
    ui.click("each side");
    CHECK_FALSE(setup.margins);
    ui.enter("Right, mm", "3");
    CHECK(setup.margins == Margins{0.25, 3, 0.25, 0.25});
    drawn.reach_mm = 3;
    ui.enter("Top, mm", "3");
    CHECK(setup.margins == Margins{3, 3, 0.25, 0.25});
    // Shown in steps of 0.05 mm, which do not drift with the number of dots.
    setup.margins.reset();
    drawn.reach_mm = 0.281;
    ui.enter("Right, mm", "4");
    CHECK(setup.margins->top == doctest::Approx(0.3));
}

TEST_CASE("a mural's sheets share strips, and say how large they are or why they cannot be") {
    PageSetup setup;
    Sheet sheets;
    LengthUnit unit = LengthUnit::mm;
    HeadlessUi ui([&] {
        draw_page_panel(setup, sheets, {.page = {200, 150, 200}}, unit);
        wide_button("Below", "");
    });
    CHECK(sheets == Sheet{});
    ui.click("More page settings");
    ui.enter("Sheets across", "2");
    ui.enter("Sheets down", "3");
    ui.enter("Overlap, mm", "1.5cm");
    CHECK(sheets == Sheet{.columns = 2, .rows = 3, .overlap_mm = 15});
    CHECK(ui.has("Sheets"));
    const WidgetPlace below = ui.place("Below");
    ui.enter("Overlap, mm", "120");
    CHECK(ui.has("No sheets"));
    CHECK(ui.place("Below") == below);
    ui.enter("Sheets across", "101");
    CHECK(sheets.columns == 2);
    ui.enter("Sheets across", "100");
    CHECK(sheets.columns == kMostSheetsAtOnce);
}

TEST_CASE("lengths are shown and typed in inches where that is chosen, and kept in millimetres") {
    ViewerSettings all;
    Appearance appearance;
    DialogChoice dialog = DialogChoice::own;
    DrawingSettings& settings = all.drawing;
    HeadlessUi ui([&] {
        draw_dots_panel(settings, {}, all.unit);
        draw_page_panel(settings.page, settings.sheets, {.page = {200, 150, 200}}, all.unit);
        draw_pen_panel(settings, all.unit);
        draw_preferences(appearance, dialog, &all.unit);
    });
    ImGui::GetIO().DisplaySize.y = 2000;
    ui.frame();
    ui.click("More page settings");
    ui.enter("Margin, mm", "10");
    CHECK(settings.page.margins->top == 10);
    const DrawingSettings before = settings;
    ui.click("inch");
    CHECK(all.unit == LengthUnit::inch);
    CHECK(settings == before);
    for (const auto& [name, place] : ui.places()) {
        const std::string& label = name;
        CAPTURE(label);
        CHECK(label.find(", mm") == std::string::npos);
    }
    ui.enter("Width, in", "8.5");
    CHECK(settings.page.width_mm == doctest::Approx(215.9));
    ui.enter("Margin, in", "12mm");
    CHECK(settings.page.margins->left == doctest::Approx(12));
    ui.click("fixed");
    ui.enter("Radius, in", "0.01");
    CHECK(settings.dot_size.radius_mm == doctest::Approx(0.254));
    // A page larger than 100 m is refused in inches.
    ui.enter("Width, in", "5000000");
    CHECK(settings.page.width_mm == 100'000);
    CHECK(ui.has("Refusal"));
}

TEST_CASE("the crop's rows are percent of the picture, keep a rest of it, and all of it is no crop") {
    PageSetup setup;
    std::optional<Crop>& crop = setup.crop;
    CropTool tool;
    HeadlessUi ui([&] { draw_crop_rows(setup, tool, {400, 200}, {1, 1}); });
    ui.click("Crop frame");
    CHECK(tool.on);
    ui.enter("From left, %", "25");
    REQUIRE(crop);
    CHECK(crop->unit == Crop::Unit::percent);
    CHECK(crop->box == Rectangle<double>{{25, 0}, {100, 100}});
    ui.enter("To right, %", "10");  // left of the left side
    CHECK(crop->box.high.x > crop->box.low.x);
    ui.enter("To right, %", "100");
    ui.enter("From left, %", "0");
    CHECK_FALSE(crop);
    CHECK_FALSE(ui.has("Remove the crop"));
    crop = Crop{{{100, 50}, {300, 150}}, Crop::Unit::pixels};
    ui.enter("From top, %", "50");
    CHECK(crop->box == Rectangle<double>{{25, 50}, {75, 75}});
    ui.click("90");
    CHECK(setup.quarter_turns == 1);
    ui.click("Remove the crop");
    CHECK_FALSE(crop);
    ui.click("Crop");
    CHECK_FALSE(tool.on);
}

TEST_CASE("a crop is kept to a proportion, as large as there is room for around its middle") {
    PageSetup setup;
    CropTool tool;
    HeadlessUi ui([&] { draw_crop_rows(setup, tool, {400, 200}, {3, 4}); });
    ui.click("Proportions");
    ui.click("1:1");
    REQUIRE(setup.crop);
    CHECK(setup.crop->box == Rectangle<double>{{25, 0}, {75, 100}});  // 200 x 200 pixels
    ui.click("Proportions");
    ui.click("page");
    CHECK(setup.crop->box == Rectangle<double>{{31.25, 0}, {68.75, 100}});  // 150 x 200
    CHECK(percent_proportion(CropProportion::picture, {{0, 0}, {50, 100}}, {400, 200}, {3, 4}) == 1);
    CHECK(percent_proportion(CropProportion::four_three, {{0, 0}, {50, 50}}, {400, 200}, {3, 4}) ==
          doctest::Approx(2.0 / 3));
    CHECK(percent_proportion(CropProportion::a_series, {{0, 0}, {10, 90}}, {400, 400}, {3, 4}) ==
          doctest::Approx(std::sqrt(0.5)));
    ui.click("Proportions");
    ui.click("free");
    CHECK(setup.crop->box == Rectangle<double>{{31.25, 0}, {68.75, 100}});
    // Dragged by a corner, the other one stays; by a side, the middle of the other sides does.
    const Rectangle<double> corner = in_proportion({{10, 10}, {50, 90}}, 1, {1, 1});
    CHECK(corner == Rectangle<double>{{10, 10}, {50, 50}});
    const Rectangle<double> side = in_proportion({{10, 40}, {40, 60}}, 1, {1, 0});
    CHECK(side == Rectangle<double>{{10, 35}, {40, 65}});
    // No further than the picture goes.
    const Rectangle<double> edge = in_proportion({{0, 80}, {100, 100}}, 1, {1, 0});
    CHECK(edge.high.y == doctest::Approx(100));
    CHECK(edge.high.x - edge.low.x == doctest::Approx(edge.high.y - edge.low.y));
}

}  // namespace dapple
