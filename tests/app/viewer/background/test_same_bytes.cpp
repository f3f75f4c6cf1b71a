#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "app/commands/batch.h"
#include "app/commands/render.h"
#include "app/commands/render_report.h"
#include "app/viewer/model/session.h"
#include "io/files/save_drawing.h"
#include "io/files/sheet_files.h"
#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {

namespace {

constexpr double kDpi = 50;
// Small, as each case reads it twice.
const std::filesystem::path kPicture = source_folder() / "assets/icon_64.png";

/// What the window is about, without it.
class SavingWindow {
 public:
    explicit SavingWindow(const DrawingSettings& drawing) : session_(drawing, [] {}) {
        session_.open(kPicture);
        REQUIRE(brings([&] { return session_.placed_once(); }));
    }
    void save(const DrawingSettings& drawing, const std::filesystem::path& file,
              const SavingChoice& saving = {.dpi = kDpi}) {
        session_.settings.drawing = drawing;
        session_.settings.saving = saving;
        session_.save(file);
        REQUIRE(brings([&] { return session_.saved_path() == file; }));
    }

 private:
    bool brings(const std::function<bool()>& done) {
        const Zoom zoom{.camera = fitted({800, 600}, {1, 1})};
        return wait_until([&] {
            session_.take_events(std::chrono::milliseconds(0));
            session_.request_dots(zoom);
            return done();
        });
    }

    Session session_;
};

RenderOptions command_for(const DrawingSettings& drawing, const std::filesystem::path& file,
                          const SavingChoice& saving = {.dpi = kDpi}) {
    RenderOptions options;
    options.image = kPicture;
    options.output = file;
    options.drawing = drawing;
    options.saving = saving;
    return options;
}

}  // namespace

TEST_CASE("window and command save the same bytes, however the page is set up") {
    TemporaryFolder folder;
    DrawingSettings drawing;
    drawing.placing.count = 1000;
    drawing.relax = 1;
    SavingWindow window(drawing);
    const auto check = [&](const DrawingSettings& wanted, const char* name) {
        const std::filesystem::path by_window = folder / name,
                                    by_command = folder / ("c_" + std::string(name));
        window.save(wanted, by_window);
        render(command_for(wanted, by_command));
        CHECK(text_of(by_window).size() > 1000);
        CHECK((text_of(by_window) == text_of(by_command)));
    };
    const PageSetup margins{.margins = Margins{10, 20, 30, 40}};
    const PageSetup part{
        .paper = Paper::custom, .width_mm = 90, .height_mm = 120, .crop = Crop{{{6, 12}, {50, 31}}}};
    const PageSetup filled{.paper = Paper::a4,
                           .orientation = PageOrientation::landscape,
                           .margins = Margins{15, 15, 15, 15},
                           .fit = PageFit::fill,
                           .quarter_turns = 1};
    DrawingSettings lines = drawing, spirals = drawing;
    drawing.edits = spirals.edits = "bare r9 60,80 99,90;dot 61,81;dot r2 p2 99,33;bare 9,9 90,20 30,70;";
    lines.edits = "bare r20 60,80;dot p3 61,81;";
    lines.pens = parse_pens("cmyk:0.4");
    lines.registration = true;
    lines.style = DrawingStyle::line;
    spirals.pens = parse_pens("Sand:#d0a040:0.5,Night:#101030:0.3:0.8");
    spirals.mark.shape = DotShape::spiral;
    for (const auto& each : {std::pair(lines, "lines.svg"), std::pair(lines, "lines.gcode"),
                             std::pair(spirals, "spirals.svg"), std::pair(spirals, "spirals.png")}) {
        CAPTURE(each.second);
        check(each.first, each.second);
    }
    // A table has all digits of every number.
    for (const auto& each : {std::pair(PageSetup{}, "plain.csv"), std::pair(margins, "margins.svg"),
                             std::pair(part, "part.csv"), std::pair(filled, "filled.png")}) {
        const char* const name = each.second;
        CAPTURE(name);
        drawing.page = each.first;
        drawing.show_tiles = drawing_format(name) == DrawingFormat::svg;
        check(drawing, name);
    }
}

TEST_CASE("window and command save the same bytes in each format, however it is to be saved") {
    TemporaryFolder folder;
    DrawingSettings drawing;
    drawing.placing.count = 500;
    drawing.relax = 1;
    SavingWindow window(drawing);
    DrawingSettings touches = drawing, nearest = drawing, greys = drawing, as_printed = drawing;
    touches.mark.shape = DotShape::point;
    nearest.style = DrawingStyle::nearest;
    greys.pens = parse_pens("greys");
    as_printed.placer = PlacerKind::figure8;
    const auto by_machine = [](GcodeTool tool) { return SavingChoice{.tool = tool, .dwell_s = 0.25}; };
    const SavingChoice own{
        .gcode_template = {"start G1 F{feed}\nmove G1 X{x} Y{y}\ndot G4 P{dwell}\n", "own"},
        .feed_mm_per_min = 1234};
    const SavingChoice deep{.dpi = kDpi, .bits = 16}, by_priority{.order = DotOrder::priority, .dpi = kDpi};
    struct Case {
        const DrawingSettings& drawing;
        SavingChoice saving;
        const char* name;
    };
    for (const Case& each :
         {Case{drawing, by_priority, "a.hpgl"}, Case{touches, {.dpi = kDpi}, "b.hpgl"},
          Case{nearest, {.dpi = kDpi}, "c.dxf"}, Case{drawing, {.dpi = kDpi}, "d.dxf"},
          Case{drawing, deep, "e.tif"}, Case{touches, deep, "f.png"}, Case{greys, by_priority, "g.json"},
          Case{nearest, {.dpi = kDpi}, "h.svg"}, Case{drawing, by_machine(GcodeTool::servo), "i.gcode"},
          Case{touches, by_machine(GcodeTool::laser), "j.gcode"}, Case{drawing, own, "k.gcode"},
          Case{as_printed, {.dpi = kDpi}, "l.svg"}}) {
        CAPTURE(each.name);
        const std::filesystem::path by_window = folder / each.name,
                                    by_command = folder / ("c_" + std::string(each.name));
        window.save(each.drawing, by_window, each.saving);
        render(command_for(each.drawing, by_command, each.saving));
        const std::string text = text_of(by_window);
        CHECK(text.size() > 1000);
        CHECK((text == text_of(by_command)));
        if (each.saving == own) CHECK(text.starts_with("G1 F1234\n"));
    }
}

TEST_CASE("window and command save the same sheets of a mural, and the same plan") {
    TemporaryFolder folder;
    DrawingSettings drawing;
    drawing.placing.count = 1000;
    drawing.relax = 1;
    drawing.page.margins = Margins{10, 20, 30, 40};
    drawing.sheets = {.columns = 2, .rows = 2, .overlap_mm = 8};
    drawing.edits = "bare r15 99,99;dot r3 100,101;";
    SavingWindow window(drawing);
    DrawingSettings lines = drawing, tiles = drawing;
    lines.style = DrawingStyle::line;
    tiles.show_tiles = true;
    for (const auto& [wanted, name] :
         {std::pair(tiles, "m.svg"), std::pair(drawing, "m.png"), std::pair(drawing, "m.csv"),
          std::pair(drawing, "d.pdf"), std::pair(lines, "m.pdf"), std::pair(lines, "m.gcode")}) {
        const std::filesystem::path by_window = folder / name, by_command = folder / "command" / name;
        std::filesystem::create_directory(folder / "command");
        window.save(wanted, by_window);
        render_mural(command_for(wanted, by_command));
        const auto files = files_of(by_window, drawing.sheets);
        const auto of_command = files_of(by_command, drawing.sheets);
        REQUIRE(files.size() == 5);
        for (std::size_t i = 0; i < files.size(); ++i) {
            CAPTURE(files[i].filename());
            CHECK(text_of(files[i]).size() > 500);
            CHECK((text_of(files[i]) == text_of(of_command[i])));
        }
    }
}

}  // namespace dapple
