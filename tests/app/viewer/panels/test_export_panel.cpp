// What the rows of an export do. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <string>

#include "app/viewer/panels/window_panels.h"
#include "core/drawing/write_drawing.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {

TEST_CASE("an export's resolution and order are set where it is asked for, for the formats that have them") {
    ViewerSettings settings;
    DrawingFormat format = DrawingFormat::svg;
    ExportInfo info{.dots = 400'000, .bytes = 23.8e6, .trouble = {}};
    HeadlessUi ui([&] { draw_export_panel(settings, format, info); });
    CHECK_FALSE(ui.has("Resolution (ppi)"));
    CHECK_FALSE(ui.has("Finding tone"));
    info.findings = {{FindingKind::tone, "the drawing is paler than the picture", "more dots"},
                     {FindingKind::overlap, "40 % of the dots overlap others", "fewer dots"}};
    ui.frame();
    CHECK_FALSE(ui.has("Finding tone"));  // folded
    ui.click("Plotting advice");
    CHECK(ui.has("Finding tone"));
    CHECK_FALSE(ui.has("Finding overlap"));  // of plotters, none of which was asked for
    ui.click("as placed");
    CHECK(settings.saving.order == DotOrder::recursion);
    ui.click("short moves");
    CHECK(settings.saving.order == DotOrder::space);
    ui.click("shortest");
    CHECK(settings.saving.order == DotOrder::shortest);
    ui.click("by priority");
    CHECK(settings.saving.order == DotOrder::priority);
    CHECK_FALSE(ui.has("Plotting time"));
    ui.click("Machine");
    ui.click("iDraw");
    CHECK(settings.saving.machine == Machine::idraw);
    CHECK(ui.has("Plotting time"));
    CHECK(ui.has("Finding overlap"));
    ui.click("Machine");
    ui.click("none");
    CHECK_FALSE(settings.saving.machine);
    ui.click("Paper in SVG");
    CHECK(settings.drawing.background);
    format = DrawingFormat::gcode;
    ui.frame();
    CHECK_FALSE(ui.has("Paper in SVG"));
    ui.click("laser");
    CHECK(settings.saving.tool == GcodeTool::laser);
    format = DrawingFormat::png;
    ui.frame();
    CHECK_FALSE(ui.has("Dot order"));
    CHECK_FALSE(ui.has("Paper in SVG"));
    ui.enter("Resolution (ppi)", "600");
    CHECK(settings.saving.dpi == 600);
    CHECK_FALSE(ui.has("Separations"));
    settings.drawing.pens.set = PenSet::cmyk;
    ui.frame();
    ui.click("Separations");
    CHECK(settings.saving.separations);
    format = DrawingFormat::gcode;
    ui.frame();
    ui.click("Pen files");
    CHECK(settings.saving.pen_files);
    format = DrawingFormat::png;
    ui.frame();
    CHECK_FALSE(ui.has("Pen files"));
    settings.drawing.pens.set = PenSet::one;
    ui.click("16");
    CHECK(settings.saving.bits == 16);
    ui.click("8");
    CHECK(settings.saving.bits == 8);
}

TEST_CASE("what is wrong with an export is mended by a click, where there is one way to mend it") {
    ViewerSettings settings;
    settings.saving.machine = Machine::axidraw_v3;
    settings.drawing.show_tiles = true;
    settings.drawing.page.margins = Margins{0, 7, 0, 0};
    ExportInfo info{.dots = 400, .bytes = 1e4, .trouble = {}};
    info.findings = {{FindingKind::hours, "plotting takes long", "8,400 dots take an hour", 8400},
                     {FindingKind::overlap, "dots overlap", "fewer part them"},
                     {FindingKind::joined, "dots are joined", "2,100 dots part them", 2100},
                     {FindingKind::over_edge, "dots reach over", "a margin helps", 0.4},
                     {FindingKind::fine_pixels, "dots are fine", "more pixels show them", 720},
                     {FindingKind::tile_layer, "the layer is drawn", "leave it out"},
                     {FindingKind::rings, "rings are drawn", "spirals fill them"}};
    HeadlessUi ui([&] { draw_export_panel(settings, DrawingFormat::svg, info); });
    ui.click("Plotting advice");
    ui.click("Use 8,400 dots");
    CHECK(settings.drawing.placing.count == 8400);
    ui.click("Use 2,100 dots");
    CHECK(settings.drawing.placing.count == 2100);
    ui.click("Set deepest black to 0.7");
    CHECK(settings.drawing.tone.black == 0.7);
    ui.frame();
    CHECK_FALSE(ui.has("Set deepest black to 0.7"));  // it would change nothing
    ui.click("Use automatic margins");
    CHECK_FALSE(settings.drawing.page.margins);
    ui.click("Use 720 ppi");
    CHECK(settings.saving.dpi == 720);
    ui.click("Hide the tile boundaries");
    CHECK_FALSE(settings.drawing.show_tiles);
    ui.click("Fill the dots with spirals");
    CHECK(settings.drawing.mark.shape == DotShape::spiral);
}

TEST_CASE("that only a region is saved is told, and a click saves the whole page again") {
    ViewerSettings settings;
    settings.saving.region = parse_region("10,20,30x40");
    HeadlessUi ui(
        [&] { draw_export_panel(settings, DrawingFormat::svg, {.dots = 400, .bytes = 1e4, .trouble = {}}); });
    settings.drawing.sheets.columns = 2;  // of the whole page
    ui.frame();
    CHECK_FALSE(ui.has("Save the whole page"));
    settings.drawing.sheets.columns = 1;
    ui.frame();
    ui.click("Save the whole page");
    CHECK_FALSE(settings.saving.region);
    ui.frame();
    CHECK_FALSE(ui.has("Save the whole page"));
}

TEST_CASE("a G-code template of one's own is named by its file, and what it says is taken over") {
    const TemporaryFolder folder;
    const std::string name = (folder / "own").string(), says = "move G1 X{x} Y{y}\ndot G4 P{dwell}\n";
    put_text(name, says);
    put_text(name + "x", "this is no template");
    ViewerSettings settings;
    HeadlessUi ui([&] {
        draw_export_panel(settings, DrawingFormat::gcode, {.dots = 400, .bytes = 1e4, .trouble = {}});
    });
    SavingChoice& saving = settings.saving;
    CHECK_FALSE(ui.has("Template"));
    ui.click("servo");
    ui.click("custom");
    CHECK(saving.gcode_template.text == gcode_template_of(GcodeTool::servo));  // until a file is named
    ui.click("Template");
    ui.type((name + "x").c_str());
    CHECK(ui.has("Refusal"));
    CHECK(saving.gcode_template.file.empty());
    ui.key(Key::backspace);
    CHECK(saving.gcode_template == OwnTemplate{says, name});
    ui.enter("Feed, mm/min", "1234");
    ui.enter("Dwell, s", "0.5");
    CHECK(saving.feed_mm_per_min == 1234);
    CHECK(saving.dwell_s == 0.5);
    ui.enter("Accel., mm/s2", "750");
    CHECK(saving.acceleration_mm_per_s2 == 750);
    CHECK(gcode_style_of(saving).lines == parse_gcode_template(says));
    ui.enter("Pen down", "75");
    CHECK(saving.pen_down == 75);
    ui.enter("Laser power", "800");
    CHECK(saving.laser_power == 800);
    ui.click("laser");
    CHECK(saving.gcode_template == OwnTemplate{});
    CHECK(saving.tool == GcodeTool::laser);
    CHECK_FALSE(saving.pen_down);  // a servo's
}

TEST_CASE("a file's size is told in round words") {
    CHECK(size_in_words({.dots = 400'000, .bytes = 23.8e6, .trouble = {}}) == "about 24 MB, 400,000 dots");
    CHECK(size_in_words({.dots = 1, .bytes = 500, .trouble = {}}) == "about 0.5 kB, 1 dot");
    CHECK(size_in_words({.dots = 10, .bytes = 1.26e9, .trouble = {}}) == "about 1.3 GB, 10 dots");
    CHECK(size_in_words({.dots = 10, .bytes = 999.9e3, .trouble = {}}) == "about 1.0 MB, 10 dots");
}

}  // namespace dapple
