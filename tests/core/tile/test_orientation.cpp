#include <doctest/doctest.h>

#include <cmath>

#include "core/tile/tile.h"

using namespace dapple;

TEST_CASE("the eight orientations form a group") {
    for (const Orientation a : all_orientations()) {
        CHECK(compose(a, inverse(a)) == Orientation{});
        CHECK(compose(inverse(a), a) == Orientation{});
        for (const Orientation b : all_orientations()) {
            const glm::dvec2 v(0.3, 0.7);
            CHECK(apply(compose(a, b), v) == apply(a, apply(b, v)));
        }
    }
}

TEST_CASE("orientations are the matrices of rotation, after a mirror for the last four") {
    CHECK(apply(Orientation{1}, glm::dvec2(1, 0)) == glm::dvec2(0, 1));
    CHECK(apply(Orientation{2}, glm::dvec2(1, 2)) == glm::dvec2(-1, -2));
    CHECK(apply(Orientation{3}, glm::dvec2(0, 1)) == glm::dvec2(1, 0));
    CHECK(apply(Orientation{4}, glm::dvec2(1, 2)) == glm::dvec2(-1, 2));
    CHECK(apply(Orientation{5}, glm::dvec2(1, 2)) == apply(Orientation{1}, glm::dvec2(-1, 2)));
}

TEST_CASE("points, vectors and quadrants are turned alike") {
    const BinaryPoint p{0x3000000000000000, 0xA000000000000000};
    for (const Orientation g : all_orientations()) {
        const glm::dvec2 expected = apply(g, to_unit_square(p) - 0.5) + 0.5;
        CHECK(std::abs(to_unit_square(apply(g, p)).x - expected.x) < 1e-15);
        CHECK(std::abs(to_unit_square(apply(g, p)).y - expected.y) < 1e-15);
        CHECK(quadrant_of(apply(g, p)) == apply_to_quadrant(g, quadrant_of(p)));
    }
}
