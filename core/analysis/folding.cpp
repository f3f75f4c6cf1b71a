#include "core/analysis/folding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/analysis/domain.h"
#include "core/analysis/point_grid.h"

namespace dapple {
namespace {

constexpr Domain kOnePeriod{1, 1, Topology::torus};

// floor() may leave 1 for a number a hair below a whole one.
double fraction(double x) {
    const double rest = x - std::floor(x);
    return rest < 1 ? rest : 0;
}

int wrapped(int i, int side) {
    return ((i % side) + side) % side;
}

}  // namespace

Folding folded(std::span<const glm::dvec2> points, glm::dvec2 corner, double period, int k) {
    assert(period > 0 && k >= 1);
    Folding folding;
    folding.layers = k * k;
    for (const glm::dvec2 p : points) {
        const glm::dvec2 at = (p - corner) / period;
        if (!(at.x >= 0 && at.y >= 0 && at.x < k && at.y < k)) continue;
        folding.points.emplace_back(fraction(at.x), fraction(at.y));
    }
    return folding;
}

double repetition(const Folding& folding, double tolerance) {
    const auto n = static_cast<double>(folding.points.size());
    if (folding.layers < 2 || n < 2) return 0;
    const double radius = tolerance * std::sqrt(folding.layers / n);
    const double chance = (n - 1) * std::numbers::pi * radius * radius;
    const double room = folding.layers - 1 - chance;
    if (room <= 0) return 0;
    const PointGrid grid(folding.points, kOnePeriod);
    std::uint64_t met = 0;
    for (const PointGrid::Entry& entry : grid.entries())
        grid.for_each_within(entry.position, radius,
                             [&](std::uint32_t other, glm::dvec2) { met += other != entry.index; });
    return (static_cast<double>(met) / n - chance) / room;
}

Grid<float> mean_of_layers(const Folding& folding, double radius, int side) {
    Grid<float> mean(side, side);
    const double reach = radius * side;
    const float share = 1 / static_cast<float>(folding.layers);
    for (const glm::dvec2 p : folding.points) {
        // The pixel centres x + 1/2 at most `reach` away, row by row.
        const glm::dvec2 at = p * static_cast<double>(side) - 0.5;
        for (int y = static_cast<int>(std::ceil(at.y - reach)); y <= at.y + reach; ++y) {
            const double half = std::sqrt(std::max(0.0, reach * reach - (y - at.y) * (y - at.y)));
            for (int x = static_cast<int>(std::ceil(at.x - half)); x <= at.x + half; ++x)
                mean.at(wrapped(x, side), wrapped(y, side)) += share;
        }
    }
    for (float& value : mean.values) value = std::min(value, 1.0f);
    return mean;
}

}  // namespace dapple
