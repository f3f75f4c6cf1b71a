// The window on screen beside the file that the command writes.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <string>

#include "app/files/picture.h"
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

}  // namespace dapple
