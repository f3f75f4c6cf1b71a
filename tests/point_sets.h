#pragma once
// Point sets with known properties, for the tests of the analysis.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

struct PointSet {
    Domain domain;
    std::vector<glm::dvec2> points;
};

/// side x side points on the unit square.
inline std::vector<glm::dvec2> square_lattice(int side) {
    std::vector<glm::dvec2> points;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) points.push_back({(x + 0.3) / side, (y + 0.7) / side});
    return points;
}

/// `columns` x 2 `rows` points of distance 1, on the torus where they close.
inline PointSet hexagonal_lattice(int columns, int rows) {
    const double height = std::sqrt(3.0);
    PointSet set{{double(columns), height * rows, Topology::torus}, {}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            set.points.push_back({x + 0.25, (y + 0.25) * height});
            set.points.push_back({x + 0.75, (y + 0.75) * height});
        }
    return set;
}

/// Independent uniform points, the same on every platform.
inline std::vector<glm::dvec2> white_noise(int count, std::uint64_t seed, const Domain& domain = {}) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double x = uniform() * domain.width;
        points.push_back({x, uniform() * domain.height});
    }
    return points;
}

/// A set on the unit torus, repeated `times` x `times` on it.
inline std::vector<glm::dvec2> repeated(const std::vector<glm::dvec2>& tile, int times) {
    std::vector<glm::dvec2> points;
    for (int y = 0; y < times; ++y)
        for (int x = 0; x < times; ++x)
            for (const glm::dvec2 p : tile) points.push_back((p + glm::dvec2(x, y)) / double(times));
    return points;
}

}  // namespace dapple
