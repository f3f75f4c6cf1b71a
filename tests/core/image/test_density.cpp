#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/image/density.h"

using namespace dapple;

namespace {

Grid<float> noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Grid<float> grid(width, height);
    for (float& v : grid.values) v = static_cast<float>(random() % 1000) / 999.0f;
    return grid;
}

}  // namespace

TEST_CASE("the density is each pixel's value at its centre and halfway between two in the middle") {
    Grid<float> grid(4, 2);
    for (int i = 0; i < 8; ++i) grid.values[i] = static_cast<float>(i) / 8;
    const Density density(grid);
    CHECK(density.at({0.125, 0.125}) == doctest::Approx(0));
    CHECK(density.at({0.375, 0.125}) == doctest::Approx(0.125));
    CHECK(density.at({0.25, 0.125}) == doctest::Approx(0.0625));
    CHECK(density.at({0.125, 0.25}) == doctest::Approx(0.25));
    CHECK(density.at({0.999, 0.01}) == doctest::Approx(0.375));
    CHECK(density.at({0.5, 0.51}) == 0);
    CHECK(density.at({-0.01, 0.1}) == 0);
    CHECK(density.mean() == doctest::Approx(28.0 / 8 / 16));
}

TEST_CASE("read by cells, the density is a pixel's value all over it, and patches lie in one pixel") {
    Grid<float> grid(3, 2);
    for (int i = 0; i < 6; ++i) grid.values[i] = static_cast<float>(i);
    const Density density(grid, Sides::paper, {0, 0}, Reading::by_cell);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (const double part : {0.0, 0.3, 1 - 1e-9})
                CHECK(density.at({(x + part) / 3, (y + part) / 3}) == 3 * y + x);
    CHECK(density.at({0.5, 0.7}) == 0);
    CHECK(density.look({4, 4, 4}).is_patch);
    CHECK(density.look({4, 4, 4}).patch.c == 0);
    CHECK_FALSE(density.look({4, 5, 4}).is_patch);  // from 0.94 to 1.13
}

TEST_CASE("no value in a square lies outside its bounds, at any depth") {
    std::mt19937 random(7);
    for (const auto& [width, height] : {std::pair{64, 64}, {100, 37}, {37, 100}, {1, 1}, {1, 300}, {5, 3}}) {
        const Grid<float> values = noise(width, height, width);
        for (const Density& density :
             {Density(values), Density(values, Sides::wrap), Density(values, Sides::paper, {0x1p-20, 0.625}),
              Density(values, Sides::paper, {349525 * 0x1p-20, 0.25}),
              Density(values, Sides::paper, {349525 * 0x1p-20, 0.25}, Reading::by_cell)}) {
            for (int trial = 0; trial < 3000; ++trial) {
                const int depth = static_cast<int>(random() % 14);
                const std::int64_t side = std::int64_t{1} << depth;
                // From all root squares.
                const QuadSquare square{depth, static_cast<std::int64_t>(random() % (2 * side)) - side,
                                        static_cast<std::int64_t>(random() % (2 * side)) - side};
                const Bounds bounds = density.bounds(square);
                for (int i = 0; i < 8; ++i) {
                    const glm::dvec2 in_square(double(random()) / 0x1p32, double(random()) / 0x1p32);
                    const glm::dvec2 p =
                        density.tile_corner() + (glm::dvec2(square.x, square.y) + in_square) / double(side);
                    const double value = density.at(p);
                    if (value < bounds.min || value > bounds.max) {
                        FAIL("at ", p.x, ",", p.y, " depth ", depth, ": ", value, " not in ", bounds.min,
                             "..", bounds.max);
                    }
                }
            }
        }
    }
}

TEST_CASE("bounds are tight: on squares within a pixel they are the corners' values") {
    const Density density(noise(16, 16, 3));
    for (std::int64_t y = 0; y < 64; ++y) {
        for (std::int64_t x = 0; x < 64; ++x) {
            const Bounds bounds = density.bounds({6, x, y});
            double low = 1, high = 0;
            for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
                // Just inside: on the page's edge the paper outside begins.
                const double value =
                    density.at({(double(x) + dx * (1 - 1e-12)) / 64, (double(y) + dy * (1 - 1e-12)) / 64});
                low = std::min(low, value);
                high = std::max(high, value);
            }
            CHECK(bounds.min == doctest::Approx(low).epsilon(1e-5));
            CHECK(bounds.max == doctest::Approx(high).epsilon(1e-5));
        }
    }
}

TEST_CASE("an environment map is interpolated across its seam") {
    Grid<float> grid(8, 4);
    for (int y = 0; y < 4; ++y) grid.at(0, y) = 1;
    CHECK(Density(grid, Sides::wrap).at({0.999999, 0.2}) == doctest::Approx(0.5).epsilon(0.001));
    CHECK(Density(grid, Sides::paper).at({0.999999, 0.2}) == 0);
}

TEST_CASE("a density that is negative or not finite is refused") {
    for (const float bad :
         {-0.1f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Grid<float> grid(3, 3, 0.5f);
        grid.at(1, 2) = bad;
        CHECK_THROWS_WITH(Density{grid}, "a density must be finite and not negative");
    }
    CHECK_THROWS(Density{Grid<float>()});
}
