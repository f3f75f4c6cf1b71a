// Whole journeys through the window, from a picture to the same drawing another day.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/window/running_viewer.h"

namespace dapple {
namespace {

// As row_keys.h notes it.
constexpr char kRowWithKeys[] = "Row with keys";

/// A small picture, darker to the right, and a project whose few dots stay where they are placed.
struct JourneyFolder {
    TemporaryFolder folder;

    JourneyFolder() {
        std::string picture = "P2\n24 16\n255\n";
        for (int pixel = 0; pixel < 24 * 16; ++pixel)
            picture += std::to_string(250 - 10 * (pixel % 24)) + "\n";
        put_text(folder / "ramp.pgm", picture);
        put_text(folder / "mask.pgm", "P2\n2 2\n255\n128 128 0 255\n");
        put_text(folder / "start.dapple", R"({"dapple": 1, "drawing": {"count": 500, "relax": 0}})");
    }
    std::string svg() const { return text_of(folder / "ramp.svg"); }
    bool has(const char* name) const { return fs::exists(folder / name); }
    /// What the window exported has to be what the command makes of the project, and what another window
    /// exports that opened it.
    void compare(const std::string& exported, const std::string& exported_later) const {
        const std::string command = (folder / "command.svg").string();
        run({dapple_program(), "render", (folder / "ramp.dapple").string(), "-o", command});
        CHECK(exported.size() > 10'000);
        CHECK((exported == text_of(command)));
        CHECK((exported == exported_later));
    }
};

/// Does something, and waits until the dots were placed anew because of it.
template <typename Do>
void place_anew(RunningViewer& viewer, const std::string& what, Do something) {
    CAPTURE(what);
    const int before = viewer.status()["placings"];
    something();
    REQUIRE(viewer.shows([&] { return viewer.status()["placings"] > before; }));
}

/// Takes the drawing away that was exported, saves the project by keys, and closes the window; the drawing.
std::string taken_with_project(RunningViewer& viewer, const JourneyFolder& files) {
    std::string exported = files.svg();
    fs::remove(files.folder / "ramp.svg");
    viewer.key("ctrl+shift+s");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return files.has("ramp.dapple"); }));
    CHECK(viewer.quit() == 0);
    return exported;
}

bool has_keys(const RunningViewer& viewer, const std::string& widget) {
    const json widgets = viewer.status()["widgets"];
    if (!widgets.contains(kRowWithKeys) || !widgets.contains(widget)) return false;
    const json &row = widgets[kRowWithKeys], &place = widgets[widget];
    const auto middle = [&](int axis) {
        return (place[axis].get<double>() + place[axis + 2].get<double>()) / 2;
    };
    return middle(0) > row[0] && middle(0) < row[2] && middle(1) > row[1] && middle(1) < row[3];
}

void walk_to(RunningViewer& viewer, const std::string& widget) {
    CAPTURE(widget);
    for (int i = 0; i < 100 && !has_keys(viewer, widget); ++i) {
        // Not by its place: that changes once more where the column is scrolled to it.
        const json before = viewer.status()["row_with_keys"];
        viewer.key("Tab");
        REQUIRE(viewer.shows([&] {
            const json now = viewer.status()["row_with_keys"];
            return now != before && now != 0;
        }));
    }
    REQUIRE(has_keys(viewer, widget));
}

void type_into(RunningViewer& viewer, const std::string& widget, const std::string& text) {
    walk_to(viewer, widget);
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return viewer.has("Typing"); }));
    viewer.xdotool("type '" + text + "'");
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return !viewer.has("Typing"); }));
}

// Until the palette is closed again: keys that come before are its own. That the dots were placed anew
// does not tell, as those of an earlier change may still be on their way.
void command(RunningViewer& viewer, const std::string& typed) {
    viewer.key("ctrl+p");
    REQUIRE(viewer.shows([&] { return viewer.has("Found"); }));
    viewer.xdotool("type '" + typed + "'");
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return !viewer.has("Found"); }));
}

}  // namespace

TEST_CASE("by keyboard: a picture opened, adjusted, laid out, exported and saved is the same another day") {
    const JourneyFolder files;
    Display display;
    std::string exported;
    {
        RunningViewer viewer(files.folder.path(), {"start.dapple"});
        const double zoom = viewer.status()["zoom"];
        viewer.key("ctrl+o");
        REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
        place_anew(viewer, "opened", [&] {
            viewer.key("ctrl+a");
            viewer.xdotool("type '" + (files.folder / "ramp.pgm").string() + "'");
            viewer.key("Return");
        });
        REQUIRE(viewer.shows([&] { return !viewer.has("Path"); }));
        // The view, while no row has the keys.
        viewer.key("plus");
        viewer.key("Left");
        CHECK(viewer.shows([&] { return viewer.status()["zoom"] != zoom; }));
        viewer.key("f");
        type_into(viewer, "Dots", "0.3k+400");
        CHECK(viewer.shows([&] { return viewer.dots() == 700; }));
        place_anew(viewer, "margin", [&] { type_into(viewer, "Margin, mm", "1cm"); });
        place_anew(viewer, "turned", [&] { viewer.key("r"); });
        place_anew(viewer, "on another paper", [&] { command(viewer, "a5"); });
        place_anew(viewer, "masked", [&] {
            command(viewer, "open mask");
            REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
            viewer.key("ctrl+a");
            viewer.xdotool("type '" + (files.folder / "mask.pgm").string() + "'");
            viewer.key("Return");
            REQUIRE(viewer.shows([&] { return !viewer.has("Path"); }));
        });
        command(viewer, "paper in svg");
        REQUIRE(viewer.shows([&] { return has_keys(viewer, "Paper in SVG"); }));
        viewer.key("space");
        walk_to(viewer, "Accept");
        viewer.key("Return");
        REQUIRE(viewer.shows([&] { return files.has("ramp.svg") && !viewer.has("Path"); }));
        exported = taken_with_project(viewer, files);
    }
    const json page = json::parse(text_of(files.folder / "ramp.dapple"));
    CHECK(page["drawing"]["count"] == 700);
    CHECK(page["drawing"]["background"] == true);
    CHECK(page["drawing"]["page"]["paper"] == "A5");
    CHECK_FALSE(page["drawing"]["mask"].empty());
    RunningViewer viewer(files.folder.path(), {"ramp.dapple"});
    viewer.key("ctrl+e");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return files.has("ramp.svg"); }));
    files.compare(exported, files.svg());
}

TEST_CASE(
    "by mouse: a picture opened, adjusted, masked, laid out, exported and saved is the same another day") {
    const JourneyFolder files;
    Display display;
    const auto in_dialog = [](RunningViewer& viewer, const char* button) {
        viewer.click(button);
        REQUIRE(viewer.shows([&] { return viewer.has("Accept"); }));
        viewer.click("Accept");
        REQUIRE(viewer.shows([&] { return !viewer.has("Accept"); }));
    };
    std::string exported;
    {
        RunningViewer viewer(files.folder.path(), {"start.dapple"});
        viewer.click("Open...");
        REQUIRE(viewer.shows([&] { return viewer.has("ramp.pgm"); }));
        place_anew(viewer, "opened", [&] { viewer.click("ramp.pgm"); });
        place_anew(viewer, "from tone", [&] {
            viewer.point_at("Brightness", 0.5);
            viewer.press();
            viewer.point_at("Brightness", 0.3);
            viewer.release();
        });
        viewer.click("Dots value");
        REQUIRE(viewer.shows([&] { return viewer.has("Typing"); }));
        place_anew(viewer, "typed, without Enter", [&] {
            viewer.xdotool("type 650");
            viewer.click("Mask");
        });
        REQUIRE(viewer.shows([&] { return viewer.has("none"); }));
        viewer.click("none");
        const json unmasked = viewer.status()["scale"];
        // Dots that settle, and a stroke that goes on, are placed again too.
        const auto is_unmasked = [&] { return viewer.status()["scale"] == unmasked; };
        viewer.move(400, 400);
        viewer.press();
        viewer.move(480, 420);
        viewer.release();
        REQUIRE(viewer.shows([&] { return !is_unmasked(); }));
        viewer.key("ctrl+z");
        REQUIRE(viewer.shows(is_unmasked));
        viewer.key("ctrl+y");
        REQUIRE(viewer.shows([&] { return !is_unmasked(); }));
        viewer.click("Back to the drawing");
        place_anew(viewer, "turned", [&] { viewer.click("Rotate"); });
        in_dialog(viewer, "Export...");
        REQUIRE(viewer.shows([&] { return files.has("ramp.svg"); }));
        exported = files.svg();
        fs::remove(files.folder / "ramp.svg");
        in_dialog(viewer, "Project...");
        REQUIRE(viewer.shows([&] { return files.has("ramp.dapple"); }));
        // the window's own button is the desktop's, and there is none here
        CHECK(viewer.quit() == 0);
    }
    const json drawing = json::parse(text_of(files.folder / "ramp.dapple"))["drawing"];
    CHECK(drawing["tone"]["brightness"] < 0);
    CHECK_FALSE(drawing["mask"].empty());
    CHECK(drawing["count"] == 650);
    RunningViewer viewer(files.folder.path(), {"ramp.dapple"});
    in_dialog(viewer, "Export...");
    REQUIRE(viewer.shows([&] { return files.has("ramp.svg"); }));
    files.compare(exported, files.svg());
}

TEST_CASE("by mouse: dots removed, added, moved, resized, whitened and lassoed, and each taken back") {
    const JourneyFolder files;
    Display display;
    std::string exported;
    std::uint64_t all = 0;
    {
        RunningViewer viewer(files.folder.path(), {"start.dapple"});
        viewer.click("Open...");
        REQUIRE(viewer.shows([&] { return viewer.has("ramp.pgm"); }));
        place_anew(viewer, "opened", [&] { viewer.click("ramp.pgm"); });
        viewer.click("Dots value");
        REQUIRE(viewer.shows([&] { return viewer.has("Typing"); }));
        viewer.xdotool("type 9000");
        viewer.click("Retouch");
        REQUIRE(viewer.shows([&] { return viewer.has("lasso") && viewer.dots() == 9000; }));
        all = viewer.dots();
        std::vector<std::uint64_t> counts{all};
        // Where the ramp is darkest, dots lie closer than a click reaches.
        const auto drag = [&](const char* hand, std::vector<glm::ivec2> way) {
            viewer.click(hand);
            place_anew(viewer, hand, [&] {
                viewer.move(way[0].x, way[0].y);
                viewer.press();
                for (const glm::ivec2 at : way) viewer.move(at.x, at.y);
                viewer.release();
            });
            counts.push_back(viewer.dots());
        };
        drag("remove", {{700, 400}});
        CHECK(viewer.dots() == all - 1);
        drag("add", {{700, 402}});
        CHECK(viewer.dots() == all);
        drag("move", {{700, 402}, {740, 440}});
        CHECK(viewer.dots() == all);
        drag("size", {{740, 440}, {760, 440}});
        CHECK(viewer.dots() == all);
        drag("whiten", {{600, 300}, {700, 320}});
        CHECK(viewer.dots() < all - 20);
        drag("lasso", {{500, 450}, {750, 450}, {740, 560}, {510, 550}});
        CHECK(viewer.dots() < counts[5] - 100);
        for (std::size_t back = counts.size() - 1; back > 0; --back) {
            place_anew(viewer, "taken back", [&] { viewer.key("ctrl+z"); });
            CHECK(viewer.dots() == counts[back - 1]);
        }
        for (std::size_t again = 1; again < counts.size(); ++again)
            place_anew(viewer, "done again", [&] { viewer.key("ctrl+y"); });
        CHECK(viewer.dots() == counts.back());
        viewer.key("Escape");
        REQUIRE(viewer.shows([&] { return !viewer.has("lasso"); }));
        viewer.key("ctrl+e");
        REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
        viewer.key("Return");
        REQUIRE(viewer.shows([&] { return files.has("ramp.svg"); }));
        exported = taken_with_project(viewer, files);
    }
    const std::string edits = json::parse(text_of(files.folder / "ramp.dapple"))["drawing"]["edits"];
    CHECK(std::ranges::count(edits, ';') == 8);
    CHECK(edits.find("dot r") != edits.npos);
    RunningViewer viewer(files.folder.path(), {"ramp.dapple"});
    viewer.key("ctrl+e");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return files.has("ramp.svg"); }));
    files.compare(exported, files.svg());
}

}  // namespace dapple
