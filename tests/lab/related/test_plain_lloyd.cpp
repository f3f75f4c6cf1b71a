#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/analysis/distances.h"
#include "lab/related/plain_lloyd.h"

using namespace dapple;

namespace {

Density ramp() {
    Grid<float> values(64, 32);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) values.at(x, y) = float(x + 1) / 64;
    return Density(std::move(values));
}

}  // namespace

TEST_CASE("a lone dot goes to the middle of the page, and its energy is the page's moment of inertia") {
    const Density grey(Grid<float>(2, 1, 1.0f));
    std::vector<glm::dvec2> dots{{0.9, 0.1}};
    const double about_the_middle = 1.0 * 0.5 * (1.0 + 0.25) / 12;
    CHECK(lloyd_step(dots, grey, LloydWeight::density) ==
          doctest::Approx(about_the_middle + 0.5 * (0.4 * 0.4 + 0.15 * 0.15)));
    CHECK(dots[0].x == doctest::Approx(0.5));
    CHECK(dots[0].y == doctest::Approx(0.25));
    CHECK(lloyd_step(dots, grey, LloydWeight::density) == doctest::Approx(about_the_middle));
}

TEST_CASE("two dots share the page at their bisector") {
    const Density grey(Grid<float>(1, 1, 1.0f));
    std::vector<glm::dvec2> dots{{0.1, 0.5}, {0.5, 0.5}};  // the bisector is x = 0.3
    lloyd_step(dots, grey, LloydWeight::density);
    CHECK(dots[0].x == doctest::Approx(0.15));
    CHECK(dots[1].x == doctest::Approx(0.65));
    CHECK(dots[0].y == doctest::Approx(0.5));
}

TEST_CASE(
    "the centroid is the weight's: of a ramp it lies two thirds of the way, of its square three quarters") {
    // Steps so small that the ramp is as good as straight from the page's one side to the other.
    Grid<float> values(1000, 1);
    for (int x = 0; x < 1000; ++x) values.at(x, 0) = (float(x) + 0.5f) / 1000;
    const Density density(std::move(values));
    std::vector<glm::dvec2> plain{{0.5, 0.0005}}, squared = plain;
    lloyd_step(plain, density, LloydWeight::density);
    lloyd_step(squared, density, LloydWeight::density_squared);
    CHECK(plain[0].x == doctest::Approx(2.0 / 3).epsilon(1e-3));
    CHECK(squared[0].x == doctest::Approx(3.0 / 4).epsilon(1e-3));
}

TEST_CASE("no step raises the energy") {
    const Density density = ramp();
    for (const LloydWeight weight : {LloydWeight::density, LloydWeight::density_squared}) {
        std::vector<glm::dvec2> dots = random_dots(density, 700, 3);
        double last = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 40; ++step) {
            const double energy = lloyd_step(dots, density, weight);
            CHECK(energy <= last * (1 + 1e-6));
            last = energy;
        }
    }
}

TEST_CASE("on even grey a hundred steps from random dots are nearly a hexagonal lattice") {
    const Density grey(Grid<float>(1, 1, 1.0f));
    std::vector<glm::dvec2> dots = random_dots(grey, 2000, 1);
    const Domain page{1, 1, Topology::window};
    CHECK(nearest_summary(dots, page).mean == doctest::Approx(0.4653).epsilon(0.05));
    for (int step = 0; step < 100; ++step) lloyd_step(dots, grey, LloydWeight::density);
    CHECK(nearest_summary(dots, page).mean >= 0.88);
}

TEST_CASE("dots tend to the root of the weight: with density squared they keep the density") {
    // (1/2)^2 of the ramp's dots lie in the left half, (1/2)^(3/2) of its root's.
    const Density density = ramp();
    const auto left_share = [&](LloydWeight weight) {
        std::vector<glm::dvec2> dots = random_dots(density, 300, 2);
        for (int step = 0; step < 300; ++step) lloyd_step(dots, density, weight);
        std::size_t left = 0;
        for (const glm::dvec2 dot : dots) left += dot.x < 0.5;
        return double(left) / double(dots.size());
    };
    CHECK(left_share(LloydWeight::density) == doctest::Approx(0.354).epsilon(0.06));
    CHECK(left_share(LloydWeight::density_squared) == doctest::Approx(0.254).epsilon(0.06));
}

TEST_CASE("random dots have the picture's density, and are the same for the same seed") {
    const std::vector<glm::dvec2> dots = random_dots(ramp(), 20'000, 5);
    std::size_t left = 0;
    for (const glm::dvec2 dot : dots) left += dot.x < 0.5;
    CHECK(double(left) / 20'000 == doctest::Approx(0.2538).epsilon(0.03));
    CHECK(dots == random_dots(ramp(), 20'000, 5));
    CHECK(dots != random_dots(ramp(), 20'000, 6));
    CHECK_THROWS(random_dots(Density(Grid<float>(3, 3, 0.0f)), 5, 1));
}

TEST_CASE("dots in white, in the same place and on the edge do no harm") {
    Grid<float> values(8, 8, 0.0f);
    values.at(6, 6) = 1;
    const Density density(std::move(values));
    std::vector<glm::dvec2> dots{{0.1, 0.1}, {0.1, 0.1}, {0, 0}, {1, 1}, {0.8, 0.8}, {0.8, 0.8}};
    for (int step = 0; step < 5; ++step) lloyd_step(dots, density, LloydWeight::density);
    CHECK(dots[0] == glm::dvec2(0.1, 0.1));
    CHECK(dots[2] == glm::dvec2(0, 0));
    for (const glm::dvec2 dot : dots) CHECK(std::isfinite(dot.x + dot.y));
}
