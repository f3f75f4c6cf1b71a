#include "lab/related/plain_voronoi.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/analysis/distances.h"

namespace dapple {
namespace {

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

void add_at(CellMoments& sum, double weight, glm::dvec2 at) {
    sum.weight += weight;
    sum.first += weight * at;
    sum.xx += weight * at.x * at.x;
    sum.xy += weight * at.x * at.y;
    sum.yy += weight * at.y * at.y;
}

// Three points inside a triangle, of its first and second side, integrate polynomials of degree 2 exactly.
constexpr glm::dvec2 kTrianglePoints[]{{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}};

CellMoments plain_moments(const Polygon& cell) {
    CellMoments sum;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const glm::dvec2 u = cell[i], v = cell[i + 1 < cell.size() ? i + 1 : 0];
        const double third = std::abs(u.x * v.y - u.y * v.x) / 6;
        for (const glm::dvec2 p : kTrianglePoints) add_at(sum, third, u * p.x + v * p.y);
        sum.area += 3 * third;
    }
    return sum;
}

class WeightedMoments {
 public:
    WeightedMoments(const Density& density, LloydWeight weight)
        : density_(density), squared_(weight == LloydWeight::density_squared) {}

    // The moments of a dot's cell, about that dot.
    CellMoments of(const Polygon& cell, glm::dvec2 dot) const {
        CellMoments sum;
        for (std::size_t i = 0; i < cell.size(); ++i)
            add_triangle(sum, dot, cell[i], cell[i + 1 < cell.size() ? i + 1 : 0]);
        return sum;
    }

 private:
    // The triangle of the dot and two corners, divided into parts * parts small ones of the same shape.
    void add_triangle(CellMoments& sum, glm::dvec2 dot, glm::dvec2 b, glm::dvec2 c) const {
        const double longest = std::sqrt(std::max({glm::dot(b, b), glm::dot(c, c), glm::dot(b - c, b - c)}));
        const int parts = std::max(1, int(std::ceil(longest * density_.longer_side())));
        sum.area += std::abs(b.x * c.y - b.y * c.x) / 2;
        const glm::dvec2 u = b / double(parts), v = c / double(parts);
        const double third = std::abs(u.x * v.y - u.y * v.x) / 6;
        const auto add = [&](double i, double j) {
            const glm::dvec2 at = u * i + v * j;
            const double density = density_.at(dot + at);
            const double weight = third * (squared_ ? density * density : density);
            add_at(sum, weight, at);
        };
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; i + j < parts; ++j) {
                for (const glm::dvec2 p : kTrianglePoints) add(i + p.x, j + p.y);
                if (i + j + 1 == parts) continue;
                for (const glm::dvec2 p : kTrianglePoints) add(i + 1 - p.x, j + 1 - p.y);
            }
        }
    }

    const Density& density_;
    bool squared_;
};

class Cells {
 public:
    explicit Cells(const PointGrid& grid) : grid_(grid) {}

    // Neighbours further away than twice the cell's furthest corner cannot cut it. The polygon is valid until
    // the next call.
    const Polygon& cell_of(const PointGrid::Entry& dot) {
        const glm::dvec2 page(grid_.domain().width, grid_.domain().height);
        const bool torus = grid_.domain().topology == Topology::torus;
        const glm::dvec2 low = torus ? -page : -dot.position, high = torus ? page : low + page;
        cell_ = {low, {high.x, low.y}, high, {low.x, high.y}};
        double reach = grid_.cell_size(), needed = 0;
        while (true) {
            grid_.for_each_within(dot.position, reach, [&](std::uint32_t index, glm::dvec2 offset) {
                // The first of several dots in the same place has the cell.
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

template <class MomentsOf>
std::vector<CellMoments> moments_in(const std::vector<glm::dvec2>& dots, const Domain& domain,
                                    const MomentsOf& moments_of) {
    const PointGrid grid(dots, domain);
    std::vector<CellMoments> moments(dots.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, dots.size(), 256), [&](const auto& range) {
        Cells cells(grid);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const PointGrid::Entry& dot = grid.entries()[i];
            moments[dot.index] = moments_of(cells.cell_of(dot), dot.position);
        }
    });
    return moments;
}

}  // namespace

std::vector<CellMoments> weighted_cells(const std::vector<glm::dvec2>& dots, const Density& density,
                                        LloydWeight weight) {
    const WeightedMoments moments(density, weight);
    const double longer = density.longer_side();
    return moments_in(dots, {density.width() / longer, density.height() / longer, Topology::window},
                      [&](const Polygon& cell, glm::dvec2 dot) { return moments.of(cell, dot); });
}

std::vector<CellMoments> plain_cells(const std::vector<glm::dvec2>& dots, const Domain& domain) {
    return moments_in(dots, domain, [](const Polygon& cell, glm::dvec2) { return plain_moments(cell); });
}

}  // namespace dapple
