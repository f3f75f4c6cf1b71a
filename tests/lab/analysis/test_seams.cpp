#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lab/analysis/seams.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("white noise has no seams, and as much bare paper as chance leaves") {
    // Independent dots cover all but exp(-load).
    const Seams noise = seams(white_noise(40'000, 9), 1.6);
    CHECK(noise.bare == doctest::Approx(std::exp(-1.6)).epsilon(0.02));
    CHECK(noise.of_halves == doctest::Approx(1).epsilon(0.15));
    CHECK(noise.of_quarters == doctest::Approx(1).epsilon(0.1));
    CHECK(noise.of_eighths == doctest::Approx(1).epsilon(0.1));
    CHECK(noise.worst() >= noise.of_halves);
}

TEST_CASE("paper that is bare along some borders is a seam of the tiles that have them") {
    // 64 columns of dots whose discs cover all; those next to x = 1/4 and 3/4 are left out, which are borders
    // of tiles of side 1/4 and 1/8 and none of those of side 1/2.
    std::vector<glm::dvec2> dots;
    for (const glm::dvec2 dot : repeated({{0.5, 0.5}}, 64)) {
        const double from_border = std::min(std::abs(dot.x - 0.25), std::abs(dot.x - 0.75));
        if (from_border > 1.0 / 64) dots.push_back(dot);
    }
    const Seams gap = seams(dots, 1.7);
    // Strips down the page are bare (r times the mean), or not at all; those across it as the page is. Of
    // halves there is one of each; of quarters three, two of them bare; of eighths seven, two of them bare.
    CHECK(gap.of_halves == doctest::Approx(0.5).epsilon(0.05));
    const double r = (6 * gap.of_quarters - 3) / 2;
    CHECK(r > 10);
    CHECK(gap.of_eighths == doctest::Approx((2 * r + 7) / 14).epsilon(0.05));
    CHECK(gap.worst() == gap.of_quarters);
}

TEST_CASE("black without bare paper has no seams") {
    CHECK(seams(repeated({{0.5, 0.5}}, 32), 4).worst() == 0);
}
