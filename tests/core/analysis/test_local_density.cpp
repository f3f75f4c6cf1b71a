#include <doctest/doctest.h>

#include "core/analysis/distances.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("a lattice has the same density everywhere, white noise varies by the root of the count") {
    const LocalDensity lattice = local_density(square_lattice(64), {});
    CHECK(lattice.columns == 8);
    CHECK(lattice.rows == 8);
    CHECK(lattice.lowest == doctest::Approx(1));
    CHECK(lattice.highest == doctest::Approx(1));
    CHECK(lattice.deviation == doctest::Approx(0));
    const Domain wide{4, 0.25, Topology::window};
    const LocalDensity noise = local_density(white_noise(65536, 3, wide), wide);
    CHECK(noise.columns == 128);
    CHECK(noise.rows == 8);
    CHECK(noise.deviation == doctest::Approx(1.0 / 8).epsilon(0.1));
}

TEST_CASE("local density is counted cell by cell, the row of smallest y first") {
    const std::vector<glm::dvec2> points{{0.1, 0.1}, {0.2, 0.3}, {0.9, 0.2}, {1.0, 1.0}};
    const LocalDensity density = local_density(points, {1, 1, Topology::window}, 1);
    REQUIRE(density.relative.size() == 4);
    CHECK(density.relative == std::vector<double>{2, 1, 0, 1});
    CHECK(density.highest == 2);
    // Over all four cells, their mean being known: the root of (1 + 0 + 1 + 0) / 4.
    CHECK(density.deviation == doctest::Approx(0.70710678));
    CHECK(density.lowest == 0);
    CHECK(local_density({}, {}).relative.empty());
}
