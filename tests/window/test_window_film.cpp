// Films in the window: played, stopped, saved.

#include <doctest/doctest.h>

#include "io/files/picture.h"
#include "tests/places.h"
#include "tests/window/running_viewer.h"

namespace dapple {
namespace {

bool film_is(const RunningViewer& viewer, const char* kind) {
    const json status = viewer.status();
    return status.contains("film") && status["film"]["kind"] == kind;
}

}  // namespace

TEST_CASE("Space plays how the drawing grows and lets it rest, and Escape brings the drawing back") {
    Display display;
    RunningViewer viewer;
    REQUIRE(viewer.is_relaxed());
    viewer.move(300, 300);
    viewer.key("space");
    REQUIRE(viewer.shows([&] { return film_is(viewer, "growth"); }));
    CHECK(viewer.shows([&] { return viewer.status()["film"]["share"] > 0.05; }));
    if (viewer.status()["film"]["running"] == true) viewer.key("space");
    REQUIRE(viewer.shows([&] { return viewer.status()["film"]["running"] == false; }));
    const double share = viewer.status()["film"]["share"];
    CHECK(viewer.shows([&] { return viewer.status()["steps"] == 0; }));
    viewer.move(310, 300);
    CHECK(viewer.status()["film"]["share"] == share);
    viewer.point_at("Moment", 0.45);
    viewer.press();
    // Half of the way by factors from 30 to 40,000.
    CHECK(viewer.shows([&] { return viewer.dots() > 500 && viewer.dots() < 2500; }));
    viewer.release();
    viewer.point_at("Moment", 0.999);
    viewer.press();
    CHECK(viewer.shows([&] { return viewer.dots() == 40'000; }));
    CHECK(viewer.shows([&] { return viewer.status()["steps"] > 0; }));  // it ends with the drawing
    viewer.release();
    viewer.key("Escape");
    REQUIRE(viewer.shows([&] { return !viewer.status().contains("film"); }));
    CHECK(viewer.is_relaxed());
    CHECK(viewer.dots() == 40'000);
    CHECK_FALSE(viewer.has("Moment"));
}

TEST_CASE(
    "the film of a plot ends with the machine's whole time, and the zoom's end leaves the view as it was") {
    Display display;
    RunningViewer viewer;
    REQUIRE(viewer.is_relaxed());
    const double zoom = viewer.status()["zoom"];
    viewer.click("Watch the plot");
    REQUIRE(viewer.shows([&] { return film_is(viewer, "plot"); }));
    // Its way is found first.
    REQUIRE(viewer.shows([&] {
        return viewer.status()["film"]["moment"].get<std::string>().find(" of ") != std::string::npos;
    }));
    CHECK(viewer.status()["film"]["share"] < 1);
    viewer.point_at("Moment", 0.999);
    viewer.press();
    CHECK(viewer.shows([&] {
        const std::string moment = viewer.status()["film"]["moment"];
        const auto of = moment.find(" of ");
        return of != std::string::npos && moment.substr(0, of) == moment.substr(of + 4);
    }));
    viewer.release();
    viewer.move(300, 300);
    viewer.key("ctrl+p");
    REQUIRE(viewer.shows([&] { return viewer.has("Commands"); }));
    viewer.xdotool("type --delay 20 'film: zoom'");
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return film_is(viewer, "zoom"); }));
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] > 5 * zoom; }));
    viewer.click("Close");
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] == zoom && !viewer.status().contains("film"); }));
}

TEST_CASE("the film that is played is saved as the command writes it") {
    TemporaryFolder folder;
    // Each of its fifty pictures is 640 pixels wide, so a picture of another shape is soon drawn.
    std::string strip = "P2\n40 2\n255\n";
    for (int pixel = 0; pixel < 40 * 2; ++pixel) strip += std::to_string(6 * (pixel % 40)) + "\n";
    put_text(folder / "strip.pgm", strip);
    put_text(folder / "strip.dapple", R"({"dapple": 1, "picture": "strip.pgm", "drawing": {"count": 300}})");
    Display display;
    RunningViewer viewer(folder.path(), {"strip.dapple"});
    viewer.move(300, 300);
    viewer.key("space");
    REQUIRE(viewer.shows([&] { return film_is(viewer, "growth"); }));
    viewer.click("Takes");
    viewer.click("Takes 2 s");
    viewer.click("Save film...");
    viewer.click("Accept");
    REQUIRE(viewer.shows([&] { return fs::exists(folder / "strip.webp"); }));
    run({dapple_program(), "record", (folder / "strip.dapple").string(), "-o",
         (folder / "command.webp").string(), "--seconds", "2"});
    CHECK((text_of(folder / "strip.webp") == text_of(folder / "command.webp")));
}

}  // namespace dapple
