#include "bench/plain_lloyd.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <stdexcept>

#include "core/analysis/point_grid.h"
#include "core/tile/random.h"

namespace dapple {
namespace {

glm::dvec2 page_of(const Density& density) {
    return glm::dvec2(density.width(), density.height()) / double(density.longer_side());
}

using Polygon = std::vector<glm::dvec2>;  // convex, seen from its dot

// Cuts off what is nearer to the neighbour at `offset` than to the dot. `spare` is working memory.
void clip(Polygon& cell, Polygon& spare, glm::dvec2 offset) {
    const double half = glm::dot(offset, offset) / 2;
    spare.clear();
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const glm::dvec2 from = cell[i], to = cell[i + 1 < cell.size() ? i + 1 : 0];
        const double a = half - glm::dot(from, offset), b = half - glm::dot(to, offset);
        if (a >= 0) spare.push_back(from);
        if ((a >= 0) != (b >= 0)) spare.push_back(from + (to - from) * (a / (a - b)));
    }
    cell.swap(spare);
}

double radius_of(const Polygon& cell) {
    double squared = 0;
    for (const glm::dvec2 corner : cell) squared = std::max(squared, glm::dot(corner, corner));
    return std::sqrt(squared);
}

struct Moments {
    double weight = 0;
    glm::dvec2 first{};
    double second = 0;
};

class CellMoments {
 public:
    CellMoments(const Density& density, LloydWeight weight)
        : density_(density), squared_(weight == LloydWeight::density_squared) {}

    // Of the cell of a dot, about that dot.
    Moments of(const Polygon& cell, glm::dvec2 dot) const {
        Moments sum;
        for (std::size_t i = 0; i < cell.size(); ++i)
            add_triangle(sum, dot, cell[i], cell[i + 1 < cell.size() ? i + 1 : 0]);
        return sum;
    }

 private:
    // The triangle of the dot and two corners, divided into parts * parts small ones of the same shape. Three
    // points inside a triangle integrate polynomials of degree 2 exactly.
    void add_triangle(Moments& sum, glm::dvec2 dot, glm::dvec2 b, glm::dvec2 c) const {
        const double longest = std::sqrt(std::max({glm::dot(b, b), glm::dot(c, c), glm::dot(b - c, b - c)}));
        const int parts = std::max(1, int(std::ceil(longest * density_.longer_side())));
        const glm::dvec2 u = b / double(parts), v = c / double(parts);
        const double third = std::abs(u.x * v.y - u.y * v.x) / 6;
        const auto add = [&](double i, double j) {
            const glm::dvec2 at = u * i + v * j;
            const double density = density_.at(dot + at);
            const double weight = third * (squared_ ? density * density : density);
            sum.weight += weight;
            sum.first += weight * at;
            sum.second += weight * glm::dot(at, at);
        };
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; i + j < parts; ++j) {
                for (const glm::dvec2 p : kPoints) add(i + p.x, j + p.y);
                if (i + j + 1 == parts) continue;
                for (const glm::dvec2 p : kPoints) add(i + 1 - p.x, j + 1 - p.y);
            }
        }
    }

    static constexpr glm::dvec2 kPoints[]{{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}};

    const Density& density_;
    bool squared_;
};

class Cells {
 public:
    explicit Cells(const PointGrid& grid) : grid_(grid) {}

    // Neighbours further away than twice the cell's furthest corner cannot cut it. The polygon is valid until
    // the next call.
    const Polygon& cell_of(const PointGrid::Entry& dot) {
        const glm::dvec2 low = -dot.position;
        const glm::dvec2 high = low + glm::dvec2(grid_.domain().width, grid_.domain().height);
        cell_ = {low, {high.x, low.y}, high, {low.x, high.y}};
        double reach = grid_.cell_size(), needed = 0;
        while (true) {
            grid_.for_each_within(dot.position, reach, [&](std::uint32_t index, glm::dvec2 offset) {
                // Of dots in the same place the first one has the cell.
                if (offset == glm::dvec2(0)) {
                    if (index < dot.index) cell_.clear();
                } else {
                    clip(cell_, spare_, offset);
                }
            });
            needed = 2 * radius_of(cell_);
            if (needed <= reach) return cell_;
            reach = std::min(needed, 2 * reach);
        }
    }

 private:
    const PointGrid& grid_;
    Polygon cell_, spare_;
};

}  // namespace

std::vector<glm::dvec2> random_dots(const Density& density, std::size_t count, std::uint64_t seed) {
    const std::vector<float>& values = density.values().values;
    const double highest = *std::max_element(values.begin(), values.end());
    if (!(highest > 0)) throw std::runtime_error("the picture is white: there is nothing to draw");
    const glm::dvec2 page = page_of(density);
    Random random(seed);
    std::vector<glm::dvec2> dots;
    dots.reserve(count);
    while (dots.size() < count) {
        const double x = random.unit() * page.x, y = random.unit() * page.y;
        if (random.unit() * highest < density.at({x, y})) dots.emplace_back(x, y);
    }
    return dots;
}

double lloyd_step(std::vector<glm::dvec2>& dots, const Density& density, LloydWeight weight) {
    const glm::dvec2 page = page_of(density);
    const PointGrid grid(dots, {page.x, page.y, Topology::window});
    const CellMoments moments(density, weight);
    std::vector<double> energies(dots.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, dots.size(), 256), [&](const auto& range) {
        Cells cells(grid);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const PointGrid::Entry& dot = grid.entries()[i];
            const Moments of_cell = moments.of(cells.cell_of(dot), dot.position);
            energies[dot.index] = of_cell.second;
            if (of_cell.weight > 0)
                dots[dot.index] =
                    glm::clamp(dot.position + of_cell.first / of_cell.weight, glm::dvec2(0), page);
        }
    });
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

}  // namespace dapple
