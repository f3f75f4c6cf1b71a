#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/lights/sampler_comparison.h"

using namespace dapple;

namespace {

// Whether each box of size 2^-across x 2^-down has one of 2^(across + down) points.
bool one_in_each(const std::vector<glm::dvec2>& points, int across, int down) {
    std::set<std::pair<int, int>> boxes;
    for (const glm::dvec2 p : points)
        boxes.emplace(static_cast<int>(p.x * (1 << across)), static_cast<int>(p.y * (1 << down)));
    return boxes.size() == points.size();
}

}  // namespace

TEST_CASE("the first Sobol' points are those that are printed everywhere") {
    const std::vector<glm::dvec2> known{{0, 0},         {0.5, 0.5},     {0.25, 0.75},   {0.75, 0.25},
                                        {0.125, 0.625}, {0.625, 0.125}, {0.375, 0.375}, {0.875, 0.875}};
    for (std::uint32_t i = 0; i < known.size(); ++i) {
        CHECK(sobol_point(i) == known[i]);
    }
}

TEST_CASE("scrambled or not, of 2^m Sobol' points each box of an area of 2^-m has one") {
    for (const int m : {1, 4, 9}) {
        // The first so many, and those that follow.
        for (const std::uint32_t begin : {0u, 1u << m, 6u << m}) {
            std::vector<std::vector<glm::dvec2>> sets(4);
            for (std::uint32_t i = begin; i < begin + (1u << m); ++i) {
                const glm::dvec2 point = sobol_point(i);
                sets[0].push_back(point);
                for (std::uint64_t seed = 1; seed < sets.size(); ++seed)
                    sets[seed].push_back(scrambled(point, seed));
            }
            for (const auto& points : sets)
                for (int across = 0; across <= m; ++across) CHECK(one_in_each(points, across, m - across));
        }
    }
}

TEST_CASE("a scrambled point may lie anywhere, its coordinates independent") {
    constexpr int kSeeds = 20'000;
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const glm::dvec2 p = scrambled(sobol_point(5), seed) - 0.5;
        x += p.x / kSeeds, y += p.y / kSeeds, xx += p.x * p.x / kSeeds, xy += p.x * p.y / kSeeds;
    }
    CHECK(x == doctest::Approx(0).epsilon(0.01));
    CHECK(y == doctest::Approx(0).epsilon(0.01));
    CHECK(xx == doctest::Approx(1 / 12.0).epsilon(0.03));
    CHECK(xy == doctest::Approx(0).epsilon(0.003));
}
