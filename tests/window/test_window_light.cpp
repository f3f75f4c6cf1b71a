// The window on screen beside the file that the command writes.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <string>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/mean_light.h"
#include "tests/places.h"
#include "tests/window/running_viewer.h"
#include "tests/window/screen.h"

namespace dapple {
namespace {

constexpr glm::dvec2 kMiddle{470,
                             385};  // of the canvas: the panel beside and the status below leave 940 x 770
constexpr double kPageSide = 200 / 25.4 * 96;  // pixels of the square page, as large as it is in the hand

}  // namespace

TEST_CASE("the window is as light as the PNG with the same settings, fitted and from afar") {
    TemporaryFolder folder;
    const std::string file = (folder / "file.png").string();
    run({dapple_program(), "render", "-o", file});
    const Grid<glm::u8vec4> saved = decode_png(text_of(file)).preview;
    const glm::dvec3 light = mean_light(saved, {{0, 0}, {saved.width, saved.height}});

    Display display;
    RunningViewer viewer;
    const auto is_as_light = [&] {
        const double side = viewer.status()["zoom"].get<double>() * kPageSide;
        // Without the page's edges, which may lie within pixels.
        const Rectangle<double> page{glm::ceil(kMiddle - side / 2), glm::floor(kMiddle + side / 2)};
        const glm::dvec3 apart = glm::abs(mean_light(screen(), page) - light);
        return std::max({apart.r, apart.g, apart.b}) < 0.01;
    };
    viewer.move(kMiddle.x, kMiddle.y);
    REQUIRE(viewer.is_relaxed());  // before pictures of the screen keep the machine busy
    CHECK(viewer.shows(is_as_light));
    for (int i = 0; i < 12; ++i) viewer.wheel_down();
    REQUIRE(viewer.shows([&] { return viewer.status()["zoom"] < 0.15; }));
    CHECK(viewer.shows(is_as_light));
}

TEST_CASE(
    "holding C shows the photograph, and letting go of it the drawing; by its name it stays until Escape") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 2 2 255 128 128 128 128");
    put_text(folder / "grey.dapple", R"({"dapple": 1, "picture": "grey.pgm", "drawing": {"count": 500}})");
    Display display;
    RunningViewer viewer(folder.path(), {"grey.dapple"});
    viewer.move(300, 300);
    // Of a drawing there are dots and paper, of the photograph its grey alone.
    const auto is_even = [] {
        const Grid<glm::u8vec3> middle = cut_out(screen(), {{440, 360}, {500, 420}});
        return std::ranges::all_of(middle.values,
                                   [&](const glm::u8vec3& pixel) { return pixel == middle.values[0]; });
    };
    CHECK(viewer.shows([&] { return !is_even(); }));
    viewer.xdotool("keydown c");
    CHECK(viewer.shows(is_even));
    viewer.xdotool("keyup c");
    CHECK(viewer.shows([&] { return !is_even(); }));
    viewer.key("ctrl+p");
    REQUIRE(viewer.shows([&] { return viewer.has("Commands"); }));
    viewer.xdotool("type --delay 20 'compare photograph'");
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return !viewer.has("Commands"); }));  // of which a part is even, too
    CHECK(viewer.shows(is_even));
    viewer.key("Escape");
    CHECK(viewer.shows([&] { return !is_even(); }));
}

TEST_CASE("holding W shows the drawing as it was; by its name it stays until something is changed") {
    const TemporaryFolder folder;
    put_text(folder / "few.dapple", R"({"dapple": 1, "drawing": {"count": 4000, "relax": 0}})");
    Display display;
    RunningViewer viewer(folder.path(), {"few.dapple"});
    const auto has = [&](std::uint64_t dots) { return viewer.shows([&] { return viewer.dots() == dots; }); };
    const auto choose = [&](const char* words) {
        viewer.move(300, 300);
        viewer.key("ctrl+p");
        REQUIRE(viewer.shows([&] { return viewer.has("Commands"); }));
        viewer.xdotool(std::string("type --delay 20 '") + words + "'");
        viewer.key("Return");
        REQUIRE(viewer.shows([&] { return !viewer.has("Commands"); }));
    };
    const auto enter_dots = [&](const char* dots) {
        viewer.click("Dots value");
        REQUIRE(viewer.shows([&] { return viewer.has("Typing"); }));
        viewer.xdotool(std::string("type --delay 20 ") + dots);
        viewer.key("Return");
        viewer.move(300, 300);
    };
    REQUIRE(has(4000));
    enter_dots("500");
    REQUIRE(has(500));
    viewer.xdotool("keydown w");
    CHECK(has(4000));
    viewer.xdotool("keyup w");
    CHECK(has(500));
    choose("compare as opened");
    CHECK(has(4000));
    enter_dots("300");
    CHECK(has(300));
    choose("keep settings");
    enter_dots("200");
    REQUIRE(has(200));
    choose("compare as opened");
    CHECK(has(300));
    viewer.key("Escape");
    CHECK(has(200));
}

}  // namespace dapple
