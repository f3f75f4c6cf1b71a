#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "app/commands/render.h"
#include "app/files/save_drawing.h"
#include "app/viewer/model/session.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {

TEST_CASE("window and command save the same bytes, however the page is set up") {
    TemporaryFolder folder;
    const Zoom zoom{.camera = fitted({800, 600}, {1, 1})};
    DrawingSettings drawing;
    drawing.placing.count = 1000;
    drawing.relax = 1;
    Session session(drawing, [] {});
    session.open_sample();
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    };
    REQUIRE(brings([&] { return session.placed_once(); }));
    const PageSetup margins{.margins = {10, 20, 30, 40}};
    const PageSetup part{
        .paper = Paper::custom, .width_mm = 90, .height_mm = 120, .crop = Crop{{{100, 200}, {800, 500}}}};
    const PageSetup filled{.paper = Paper::a4,
                           .orientation = PageOrientation::landscape,
                           .margins = {15, 15, 15, 15},
                           .fit = PageFit::fill,
                           .quarter_turns = 1};
    // A table has all digits of every number.
    for (const auto& each : {std::pair(PageSetup{}, "plain.csv"), std::pair(margins, "margins.svg"),
                             std::pair(part, "part.csv"), std::pair(filled, "filled.png")}) {
        const char* const name = each.second;
        CAPTURE(name);
        drawing.page = each.first;
        drawing.show_tiles = drawing_format(name) == DrawingFormat::svg;
        session.settings.drawing = drawing;
        session.settings.saving.dpi = 50;
        const std::filesystem::path by_window = folder / name,
                                    by_command = folder / ("c_" + std::string(name));
        session.save(by_window);
        REQUIRE(brings([&] { return session.saved_path() == by_window; }));
        RenderOptions options;
        options.output = by_command;
        options.drawing = drawing;
        options.saving.dpi = 50;
        render(options);
        CHECK(text_of(by_window).size() > 1000);
        CHECK((text_of(by_window) == text_of(by_command)));
    }
}

}  // namespace dapple
