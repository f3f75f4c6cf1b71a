// The rows of the tool "Mask", used without a window.

#include <doctest/doctest.h>

#include "app/viewer/panels/settings_panels.h"
#include "core/image/mask.h"
#include "tests/headless_ui.h"

namespace dapple {

TEST_CASE("the brush is chosen by what it paints, and is off where its section is folded") {
    DrawingSettings drawing;
    MaskBrush brush;
    HeadlessUi ui([&] { draw_mask_panel(drawing, brush); });
    for (const auto& [name, kind] :
         {std::pair("none", BrushKind::none), {"fewer", BrushKind::fewer}, {"finer", BrushKind::finer}}) {
        ui.click(name);
        CHECK(brush.on);
        CHECK(brush.brush.kind == kind);
    }
    ui.click("off");
    CHECK_FALSE(brush.on);
    ui.click("erase");
    CHECK(brush.on);
    ui.click("Mask");
    CHECK_FALSE(brush.on);
}

TEST_CASE("the brush's size is typed in percent, or stepped by keys") {
    DrawingSettings drawing;
    MaskBrush brush;
    HeadlessUi ui([&] { draw_mask_panel(drawing, brush); });
    ui.click("more");
    ui.enter("Size, %", "10");
    CHECK(brush.brush.radius == doctest::Approx(0.1));
    resize_brush(brush, 1);
    CHECK(brush.brush.radius == doctest::Approx(0.125));
}

TEST_CASE("the brush for finer dots says so where a drawing has none") {
    DrawingSettings drawing;
    MaskBrush brush;
    HeadlessUi ui([&] { draw_mask_panel(drawing, brush); });
    ui.click("finer");
    CHECK_FALSE(ui.has("Not finer"));
    drawing.style = DrawingStyle::line;
    ui.frame();
    CHECK(ui.has("Not finer"));
}

TEST_CASE("a mask is cleared by its button, which is not there without one") {
    DrawingSettings drawing;
    MaskBrush brush;
    bool cleared = false;
    HeadlessUi ui([&] { cleared |= draw_mask_panel(drawing, brush); });
    CHECK_FALSE(ui.has("Clear the mask"));
    BrushStroke stroke(drawing.mask, {100, 100}, {.kind = BrushKind::none});
    stroke.go_to({0.5, 0.5});
    drawing.mask = stroke.mask();
    REQUIRE_FALSE(drawing.mask.empty());
    ui.frame();
    ui.click("Clear the mask");
    CHECK(cleared);
    CHECK(drawing.mask.empty());
}

}  // namespace dapple
