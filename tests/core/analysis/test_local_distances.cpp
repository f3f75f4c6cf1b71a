#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/analysis/distances.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("a square lattice on even grey has the square lattice's distance, whatever the grey") {
    for (const float grey : {0.3f, 1.0f}) {
        const Density density(Grid<float>(1, 1, grey));
        const std::vector<glm::dvec2> dots = square_lattice(40);
        const LocalDistances judged = local_distances(dots, density, dots_at_full_density(density, 1600));
        CHECK(judged.mean == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)));
        CHECK(judged.p1 == doctest::Approx(judged.mean));
        CHECK(judged.count == 38 * 38);  // without those within a spacing of the edge
    }
}

TEST_CASE("two lattices, one of twice the spacing in a quarter of the density, are alike") {
    // Dark on the left, light on the right, with nothing judged where they meet or where it is white.
    Grid<float> values(4, 1);
    values.values = {0.8f, 0.8f, 0.2f, 0.2f};
    const Density density(std::move(values));
    std::vector<glm::dvec2> dots;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 15; ++x) dots.emplace_back(0.0125 + x * 0.025, 0.0125 + y * 0.025);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) dots.emplace_back(0.65 + x * 0.05, 0.025 + y * 0.05);
    const LocalDistances judged = local_distances(dots, density, 1600 / 0.8);
    CHECK(judged.p1 == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)).epsilon(1e-4));
    CHECK(judged.mean == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)).epsilon(1e-4));
}

TEST_CASE("independent dots have white noise's mean, and dots in white are not judged") {
    const Density grey(Grid<float>(1, 1, 0.5f));
    const std::vector<glm::dvec2> noise = white_noise(20'000, 4);
    CHECK(local_distances(noise, grey, dots_at_full_density(grey, noise.size())).mean ==
          doctest::Approx(0.4653).epsilon(0.02));
    CHECK(local_distances(noise, Density(Grid<float>(1, 1, 0.005f)), 1).count == 0);
}
