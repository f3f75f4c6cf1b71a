#include <doctest/doctest.h>

#include <cmath>

#include "core/analysis/autocorrelation.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("a repeated tile meets itself after its period and not after half of it") {
    const auto points = repeated(white_noise(100, 4), 16);
    CHECK(autocorrelation(points, {}, {1 / 16.0, 0}) == doctest::Approx(1));
    CHECK(autocorrelation(points, {}, {-3 / 16.0, 5 / 16.0}) == doctest::Approx(1));
    CHECK(std::abs(autocorrelation(points, {}, {1 / 32.0, 0})) < 0.1);  // 100 different points
    CHECK(autocorrelation(points, {1, 1, Topology::window}, {1 / 16.0, 0}) == doctest::Approx(1));
    const Periodicity found = periodicity(points, {}, {1 / 16.0, 1 / 16.0});
    CHECK(found.value == doctest::Approx(1));
    CHECK(found.lag_x == 1);
    CHECK(found.lag_y == 0);
}

TEST_CASE("independent points meet by chance only") {
    const auto points = white_noise(20000, 8);
    CHECK(std::abs(autocorrelation(points, {}, {0.25, 0.125})) < 0.006);  // 4 standard deviations
    CHECK(periodicity(points, {}, {1 / 32.0, 1 / 32.0}).value < 0.015);
    CHECK(periodicity(points, {1, 1, Topology::window}, {1 / 32.0, 1 / 32.0}).value < 0.015);
}

TEST_CASE("the share that repeats is the autocorrelation") {
    // Every tile has 30 points in common with the others and 70 of its own.
    const auto common = white_noise(30, 12);
    auto points = repeated(common, 16);
    const auto own = white_noise(70 * 256, 13);
    points.insert(points.end(), own.begin(), own.end());
    CHECK(autocorrelation(points, {}, {1 / 16.0, 0}) == doctest::Approx(0.3).epsilon(0.03));
    CHECK(periodicity(points, {}, {1 / 16.0, 1 / 16.0}).value == doctest::Approx(0.3).epsilon(0.1));
}

TEST_CASE("lags that bring a torus back onto itself don't count") {
    const auto points = white_noise(500, 6);
    CHECK(autocorrelation(points, {}, {1, 0}) == doctest::Approx(1));
    CHECK(periodicity(points, {}, {1, 1}).value == 0);
    CHECK(periodicity(points, {}, {0.5, 0.5}).value < 0.2);
    CHECK(periodicity(points, {1, 1, Topology::window}, {2, 2}).value == 0);  // nothing is that far away
    CHECK(periodicity({}, {}, {0.5, 0.5}).value == 0);
}

TEST_CASE("a lag that leaves a handful of points inside a window says nothing") {
    // Points on the left and right edge would all meet each other, the others do not.
    auto points = white_noise(2000, 15);
    for (int y = 0; y < 20; ++y) {
        points.push_back({0, y / 20.0});
        points.push_back({1, y / 20.0});
    }
    const Domain window{1, 1, Topology::window};
    CHECK(autocorrelation(points, window, {1, 0}) == doctest::Approx(1));
    CHECK(periodicity(points, window, {1 / 8.0, 1 / 8.0}).value < 0.05);
}
