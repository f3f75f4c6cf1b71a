// Files that the window saves, and what it asks before something would be lost.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/file_text.h"
#include "tests/window/running_viewer.h"

namespace dapple {

TEST_CASE("a drawing is exported beside its picture") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    const TemporaryFolder elsewhere;
    Display display;
    RunningViewer viewer(elsewhere.path(), {(folder / "grey.pgm").string()});
    viewer.key("ctrl+e");
    viewer.click("Accept");
    CHECK(viewer.shows([&] { return fs::exists(folder / "grey.svg"); }));
    CHECK(fs::is_empty(elsewhere.path()));
}

TEST_CASE("what is not saved is asked about before the window closes: it can stay, save, or let go of it") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    Display display;
    RunningViewer viewer(folder.path(), {"grey.pgm"});
    viewer.click("More tone settings");
    viewer.click("Invert");
    CHECK(viewer.is_titled("^[*]grey.pgm - Dapple$"));
    viewer.move(300, 300);
    viewer.key("ctrl+q");
    REQUIRE(viewer.shows([&] { return viewer.has("Discard"); }));
    viewer.click("Cancel");
    REQUIRE(viewer.shows([&] { return !viewer.has("Discard"); }));
    viewer.key("ctrl+z");
    CHECK(viewer.is_titled("^grey.pgm - Dapple$"));
    viewer.key("ctrl+y");
    CHECK(viewer.is_titled("^[*]grey.pgm - Dapple$"));
    viewer.key("ctrl+q");
    viewer.click("Save");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    CHECK(viewer.wait_for_end() == 0);
    CHECK(json::parse(text_of(folder / "grey.dapple"))["drawing"]["tone"]["invert"] == true);
}

TEST_CASE("a window that is still saving asks before it goes, and goes once the file is whole") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    // Saving waits for somebody who reads it.
    REQUIRE(::mkfifo((folder / "grey.svg").c_str(), 0600) == 0);
    Display display;
    RunningViewer viewer(folder.path(), {"grey.pgm"});
    const auto save = [&] {
        viewer.move(300, 300);
        viewer.key("ctrl+e");
        viewer.click("Accept");
        viewer.click("Replace");
        REQUIRE(viewer.shows([&] { return viewer.has("Cancel saving"); }));
    };
    save();
    viewer.key("ctrl+q");
    REQUIRE(viewer.shows([&] { return viewer.has("Quit now"); }));
    viewer.key("Escape");
    REQUIRE(viewer.shows([&] { return !viewer.has("Quit now"); }));
    CHECK(viewer.has("Cancel saving"));
    viewer.key("ctrl+q");
    viewer.click("Quit when saved");
    REQUIRE(viewer.shows([&] { return !viewer.has("Quit now"); }));
    CHECK_FALSE(viewer.has_ended());
    const std::string drawing = text_of(folder / "grey.svg");  // to its end
    CHECK(drawing.ends_with("</svg>\n"));
    CHECK(viewer.wait_for_end() == 0);
}

TEST_CASE("Escape stops an export") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    // Saving waits for somebody who reads it.
    REQUIRE(::mkfifo((folder / "grey.svg").c_str(), 0600) == 0);
    Display display;
    RunningViewer viewer(folder.path(), {"grey.pgm"});
    viewer.move(300, 300);
    viewer.key("ctrl+e");
    viewer.click("Accept");
    viewer.click("Replace");
    REQUIRE(viewer.shows([&] { return viewer.has("Cancel saving"); }));
    viewer.move(300, 300);
    viewer.key("Escape");
    CHECK(viewer.shows([&] {
        return viewer.has("Cancelled: " + (folder / "grey.svg").string() + " was not written") &&
               !viewer.has("Cancel saving");
    }));
}

TEST_CASE("a key that was typed before a question was there does not answer it") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    put_text(folder / "grey.svg", "another");
    Display display;
    RunningViewer viewer(folder.path(), {"grey.pgm"});
    viewer.move(300, 300);
    viewer.key("ctrl+e");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.at_once([&] { viewer.xdotool("key Return Return"); });
    REQUIRE(viewer.shows([&] { return viewer.has("Replace"); }));
    viewer.move(310, 300);
    CHECK(viewer.has("Replace"));
    CHECK(text_of(folder / "grey.svg") == "another");
    viewer.key("Return");
    CHECK(viewer.shows([&] { return text_of(folder / "grey.svg").ends_with("</svg>\n"); }));
}

TEST_CASE("a drawing that was not saved when the program was killed comes back, and is still to be saved") {
    TemporaryFolder folder;
    const WindowMemory memory{folder / "home"};
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    const auto kept = [&] {
        std::size_t files = 0;
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(memory.folder / "dapple/unsaved", ignored))
            files += entry.path().extension() == ".dapple" ? 1 : 0;
        return files;
    };
    Display display;
    std::uint64_t dots = 0;
    {
        RunningViewer viewer(folder.path(), {"grey.pgm"}, memory);
        viewer.point_at("Dots", 0.3);
        viewer.press();
        viewer.release();
        REQUIRE(viewer.shows([&] { return viewer.dots() < 40'000 && kept() == 1; }));
        dots = viewer.dots();
        viewer.kill_at_once();
        CHECK(viewer.wait_for_end() == 128 + SIGKILL);
    }
    {
        RunningViewer viewer({}, {}, memory);
        CHECK(viewer.dots() == 40'000);
        viewer.click("Restore");
        CHECK(viewer.shows([&] { return viewer.dots() == dots; }));
        CHECK(viewer.is_titled("^[*]grey.pgm - Dapple$"));
        CHECK(kept() == 1);
        CHECK(viewer.quit() == 0);
    }
    CHECK(kept() == 0);
}

}  // namespace dapple
