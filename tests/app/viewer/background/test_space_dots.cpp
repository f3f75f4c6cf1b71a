// The dots in space that the window shows.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "app/files/volume_file.h"
#include "app/viewer/background/space_dots.h"
#include "core/volume/volume.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

namespace dapple {

TEST_CASE("the window's dots in space are those that the command writes") {
    const TemporaryFolder folder;
    const auto written = [&](const std::string& options) {
        const std::filesystem::path file = folder / "dots.ply";
        REQUIRE(run_dapple("volume " + options + " -o " + file.string()).status == 0);
        return read_ply(file);
    };
    const auto shown = [](const SpaceChoice& choice) {
        std::vector<glm::dvec3> places = dots_in_space(choice).places;
        for (glm::dvec3& place : places) place = glm::vec3(place);  // files have floats
        return places;
    };
    CHECK(shown({SpaceVolume::cube, 100, true}) == written("cube -n 100"));
    CHECK(shown({SpaceVolume::ball, 321, false}) == written("ball -n 321 --relax 0"));
    CHECK(shown({SpaceVolume::gyroid, 700, true}) == written("gyroid -n 700 --relax 20"));
}

TEST_CASE("they are told of as placed and after each step, until that is enough") {
    std::vector<int> steps;
    const SpaceDots dots = dots_in_space({SpaceVolume::cube, 200, true}, [&](const SpaceDots& now) {
        CHECK(now.places.size() == 200);
        steps.push_back(now.steps);
        return now.steps < 2;
    });
    CHECK(steps == std::vector{0, 1, 2});
    CHECK(dots.steps == 2);
    CHECK(dots.all_steps == 20);
    CHECK(dots_in_space({SpaceVolume::cube, 200, false}).all_steps == 0);
}

TEST_CASE("of an even cube's dots as many are the tile's own as it has points, of fewer dots all") {
    CHECK(dots_in_space({SpaceVolume::cube, 1000, true}).of_tile == volume_tile().size());
    CHECK(dots_in_space({SpaceVolume::cube, 50, false}).of_tile == 50);
    const SpaceDots ball = dots_in_space({SpaceVolume::ball, 1000, false});
    const Volume volume = ball_volume();
    const auto points = volume_tile().points;
    CHECK(
        static_cast<std::ptrdiff_t>(ball.of_tile) ==
        std::ranges::count_if(points, [&](const glm::dvec3& point) { return volume.at(point * 64.0) > 0; }));
}

TEST_CASE("with boundaries the cube has edges along all its eighths, and each eighth a colour") {
    const SpaceDots dots = dots_in_space({SpaceVolume::cube, 500, false});
    const std::vector<Ball> plain = balls_of(dots, false), divided = balls_of(dots, true);
    CHECK(plain.size() == 500);
    std::set<std::tuple<float, float, float>> colours;
    for (std::size_t i = dots.of_tile; i < 500; ++i) {
        const glm::vec3 ink = divided[i].ink;
        colours.emplace(ink.r, ink.g, ink.b);
        CHECK(divided[i].place == dots.places[i]);
        CHECK(divided[i].radius < divided[0].radius);
    }
    CHECK(colours.size() == 8);
    std::set<std::tuple<double, double, double>> corners;
    for (std::size_t i = 500; i < divided.size(); ++i) {
        const glm::dvec3 place = divided[i].place;
        int on_planes = 0;
        for (int axis = 0; axis < 3; ++axis)
            on_planes += place[axis] == 0 || place[axis] == 32 || place[axis] == 64;
        CHECK(on_planes >= 2);
        if (on_planes == 3) corners.emplace(place.x, place.y, place.z);
    }
    CHECK(corners.size() == 27);
}

}  // namespace dapple
