// Plain densities to place dots on instead of a photograph.

#include <doctest/doctest.h>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/background/workbench.h"

namespace dapple {

TEST_CASE("the grey is the same density everywhere") {
    const Density grey = plain_density({DensitySource::grey, 0.3});
    CHECK(grey.mean() == doctest::Approx(0.3));
    CHECK(grey.at({0.1, 0.9}) == doctest::Approx(0.3));
}

TEST_CASE("the ramp rises evenly from left to right") {
    const Density ramp = plain_density({DensitySource::ramp});
    CHECK(ramp.width() == 2 * ramp.height());
    for (const double x : {0.1, 0.25, 0.5, 0.9})
        for (const double y : {0.01, 0.2, 0.49}) CHECK(ramp.at({x, y}) == doctest::Approx(x));
}

TEST_CASE("a workbench places on the density that was chosen and goes back to the photograph") {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(64, 32, 0.25f)});
    DrawingSettings settings;
    settings.placing.count = 3000;
    PlacedDrawing drawing;
    REQUIRE(bench.place(dots_request(settings, {DensitySource::ramp}), drawing));
    CHECK(drawing.plan.picture_size() == glm::dvec2(1, 0.5));
    REQUIRE(drawing.dots.size() == 3000);
    // A linear ramp has a quarter of its dots in the left half.
    int left = 0;
    const auto count_left = [&left](float x, float) { left += x < 0.5f; };
    for_each_position(drawing.dots, count_left);
    CHECK(left == doctest::Approx(750).epsilon(0.05));

    REQUIRE(bench.place(dots_request(settings, {DensitySource::grey, 0.2}), drawing));
    CHECK(drawing.plan.picture_size() == glm::dvec2(1, 1));
    REQUIRE(bench.place(dots_request(settings), drawing));
    CHECK(drawing.plan.picture_size() == glm::dvec2(1, 0.5));
    left = 0;
    for_each_position(drawing.dots, count_left);
    CHECK(left == doctest::Approx(1500).epsilon(0.05));
}

TEST_CASE("what no dot depends on asks for no other dots, and all else does") {
    DrawingSettings settings;
    const DotsRequest before = dots_request(settings);
    const auto same = [&](const auto& change) {
        DrawingSettings changed = settings;
        change(changed);
        CHECK(changed != settings);
        return dots_request(changed) == before;
    };
    CHECK(same([](auto& s) { s.ink = {1, 0, 0}; }));
    CHECK(same([](auto& s) { s.background = true; }));
    CHECK(same([](auto& s) { s.registration = true; }));
    CHECK(same([](auto& s) { s.sheets = {.columns = 2, .rows = 3}; }));
    CHECK_FALSE(same([](auto& s) { s.tone.gamma = 2; }));
    CHECK_FALSE(same([](auto& s) { s.tile = "paper16"; }));
    CHECK_FALSE(same([](auto& s) { s.ranking = RankingMethod::farthest; }));
    CHECK_FALSE(same([](auto& s) { s.show_tiles = true; }));
    CHECK_FALSE(same([](auto& s) { s.pen_width_mm = 0.7; }));
}

}  // namespace dapple
