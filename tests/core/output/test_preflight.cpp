#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <utility>

#include "core/output/findings.h"

using namespace dapple;

namespace {

constexpr PageSize kPage{100, 50, 100};

Dots dots_at_mm(std::initializer_list<std::pair<float, float>> places_mm) {
    Dots dots;
    for (const auto& [x, y] : places_mm) {
        dots.x.push_back(x / 100);
        dots.y.push_back(y / 100);
    }
    return dots;
}

}  // namespace

TEST_CASE("a pen's way is the length of the straight lines from dot to dot") {
    // Sides 3, 4 and 5 of a triangle, then nothing.
    CHECK(preflight(dots_at_mm({{10, 10}, {13, 10}, {13, 14}, {10, 10}}), kPage, 0.1).pen_up_m ==
          doctest::Approx(0.012));
    CHECK(preflight(dots_at_mm({{10, 10}}), kPage, 0.1).pen_up_m == 0);
    CHECK(std::isinf(preflight(dots_at_mm({{10, 10}}), kPage, 0.1).nearest_mm));
    CHECK(preflight({}, kPage, 0.1).over_edge == 0);
}

TEST_CASE("dots that a plotter's program joins are counted by its own distance") {
    const Preflight found =
        preflight(dots_at_mm({{10, 10}, {10.1f, 10}, {20, 20}, {20, 20.4f}, {40, 40}}), kPage, 0.1);
    CHECK(found.nearest_mm == doctest::Approx(0.1).epsilon(1e-4));
    CHECK(found.nearer_than_axidraw == 2);
    CHECK(found.nearer_than_saxi == 4);
}

TEST_CASE("one dot in a hundred is nearer to another than the first percentile") {
    Dots dots;  // in pairs, each further apart than the one before
    for (int pair = 0; pair < 500; ++pair)
        for (const float x : {0.0f, 0.001f + 1e-5f * static_cast<float>(pair)}) {
            dots.x.push_back(0.02f * static_cast<float>(pair % 50) + x);
            dots.y.push_back(0.04f * static_cast<float>(pair / 50));
        }
    // Five pairs are nearer than the sixth, which is 0.1 mm and five hundredths of one apart.
    CHECK(preflight(dots, kPage, 0.1).first_percentile_mm == doctest::Approx(0.105).epsilon(1e-4));
    CHECK(std::isinf(preflight(dots_at_mm({{10, 10}}), kPage, 0.1).first_percentile_mm));
}

TEST_CASE("dots that reach over any edge of the page are counted") {
    CHECK(preflight(dots_at_mm({{0.3f, 20}, {50, 0.3f}, {99.7f, 20}, {50, 49.7f}, {50, 25}}), kPage, 0.4)
              .over_edge == 4);
    CHECK(preflight(dots_at_mm({{0.5f, 20}, {50, 25}}), kPage, 0.4).over_edge == 0);
}

TEST_CASE("of dots of several sizes each reaches over the edge as far as its own radius") {
    Dots dots = dots_at_mm({{0.3f, 20}, {50, 0.3f}, {50, 25}});
    dots.radius = {0.002f, 0.004f, 0.004f};  // page units
    CHECK(preflight(dots, kPage, 0.4).over_edge == 1);
}

TEST_CASE("dots seen from a corner on the page are measured where they lie on it") {
    const Dots dots = dots_at_mm({{0.3f, 20}, {49.7f, 20}});
    CHECK(preflight(dots, kPage, 0.4, {}, {50, 0}).over_edge == 1);
    CHECK(preflight(dots, kPage, 0.4, {}, {20, 0}).over_edge == 0);
}

TEST_CASE(
    "the ink of a touch is as wide as the pen, that of a shape as the dot or the pen, whichever is wider") {
    InkedDot ink{.as = DotsAs::touches, .radius_mm = 0.4, .stroke_width_mm = 0.3};
    CHECK(ink.reach_mm(0.4, 0) == 0.15);
    ink.as = DotsAs::shapes;
    CHECK(ink.reach_mm(0.4, 0) == 0.4);
    CHECK(ink.reach_mm(0.1, 0) == 0.15);
    ink.widths_mm = {0.3, 1};
    CHECK(ink.reach_mm(0.4, 1) == 0.5);
    ink.as = DotsAs::rings;
    CHECK(ink.reach_mm(0.4, 1) == 0.4);
}

TEST_CASE("dots of pens with several widths overlap by each pen's own") {
    DotPieces pieces;
    pieces.pieces.push_back(dots_at_mm({{10, 10}, {30, 10}}));
    pieces.pieces.push_back(dots_at_mm({{10.5f, 10}, {30.9f, 10}}));
    pieces.pieces[1].pen = 1;
    const InkedDot ink{.as = DotsAs::touches, .stroke_width_mm = 0.3, .widths_mm = {0.4, 0.8}};
    const Dots inked = inked_dots(stream_of(pieces), ink, kPage);
    REQUIRE(inked.radius.size() == 4);
    CHECK(preflight(inked, kPage, 0.2).overlapping == 2);
    const InkedDot alike{.as = DotsAs::touches, .stroke_width_mm = 0.3, .widths_mm = {0.4, 0.4}};
    CHECK(inked_dots(stream_of(pieces), alike, kPage).radius.empty());
}

TEST_CASE("dots with a part in the margins are counted, each with its own radius") {
    const Rectangle<double> within{{10, 5}, {90, 45}};
    Dots dots = dots_at_mm({{10.3f, 20}, {50, 5.3f}, {89.7f, 20}, {50, 44.7f}, {50, 25}, {10.4f, 20}});
    CHECK(preflight(dots, kPage, 0.4, within).outside_margins == 4);
    CHECK(preflight(dots, kPage, 0.4).outside_margins == 0);
    dots.radius = {0.002f, 0.004f, 0.002f, 0.004f, 0.002f, 0.002f};  // page units
    CHECK(preflight(dots, kPage, 0.4, within).outside_margins == 2);
}

TEST_CASE("dots that reach into others are counted by their radii, and their outlines are 2 pi r each") {
    Dots dots = dots_at_mm({{10, 10}, {11, 10}, {20, 20}, {22.5f, 20}, {40, 40}});
    const Preflight equal = preflight(dots, kPage, 0.6);
    CHECK(equal.overlapping == 2);
    CHECK(equal.rings_m == doctest::Approx(5 * 2 * 3.14159265 * 0.6 / 1000));
    for (const float mm : {0.4f, 0.4f, 2.0f, 0.6f, 3.0f}) dots.radius.push_back(mm / 100);
    const Preflight unequal = preflight(dots, kPage, 3);
    CHECK(unequal.overlapping == 2);
    CHECK(unequal.rings_m == doctest::Approx(6.4 * 2 * 3.14159265 / 1000));
}

TEST_CASE("the distances of many dots are those found by comparing all pairs") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place;
    Dots dots;
    for (int i = 0; i < 2000; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random) / 2);
    }
    std::uint64_t near = 0;
    double nearest = 1e9;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        double distance = 1e9;
        for (std::size_t k = 0; k < dots.size(); ++k) {
            if (k == i) continue;
            distance = std::min(
                distance, 100 * std::hypot(double(dots.x[i]) - dots.x[k], double(dots.y[i]) - dots.y[k]));
        }
        near += distance < 0.5;
        nearest = std::min(nearest, distance);
    }
    const Preflight found = preflight(dots, kPage, 0.1);
    CHECK(found.nearer_than_saxi == near);
    CHECK(found.nearest_mm == doctest::Approx(nearest));
}
