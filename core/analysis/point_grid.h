#pragma once
// Points sorted into square-ish cells of about two points each, to find those near a place.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

class PointGrid {
 public:
    /// `points` lie in the domain (points_inside()); fewer than 2^32 of them. They are copied.
    PointGrid(std::span<const glm::dvec2> points, const Domain& domain);

    /// A point where it lies in memory, which is in the order of the cells.
    struct Entry {
        glm::dvec2 position;
        std::uint32_t index;
    };

    /// Calls visit(index, offset) for every point at distance <= radius of `centre`, where offset is the way
    /// from centre to the point. On a torus every image of a point counts by itself, the point's own images
    /// included, so a radius over half a period is fine. The order is fixed by the points alone.
    template <class Visit>
    void for_each_within(glm::dvec2 centre, double radius, Visit&& visit) const {
        for_each_around(centre, radius, [&](const Entry& entry, glm::dvec2 offset) {
            if (offset.x * offset.x + offset.y * offset.y <= radius * radius) visit(entry.index, offset);
        });
    }

    /// The same for the points of all cells within the radius, some of which are farther away.
    template <class Visit>
    void for_each_around(glm::dvec2 centre, double radius, Visit&& visit) const {
        const Cells x = cells(centre.x, radius, cell_.x, columns_);
        const Cells y = cells(centre.y, radius, cell_.y, rows_);
        for (long row = y.first; row <= y.last; ++row) {
            const long turns_y = floor_div(row, rows_);
            // The cells of a row follow each other in memory, up to the domain's edge.
            for (long column = x.first; column <= x.last;) {
                const long turns_x = floor_div(column, columns_);
                const long end = std::min(x.last + 1, (turns_x + 1) * columns_);
                const glm::dvec2 shift(double(turns_x) * domain_.width, double(turns_y) * domain_.height);
                const long cell = (row - turns_y * rows_ - turns_x) * columns_ + column;
                const Entry* const last = sorted_.data() + start_[std::size_t(cell + end - column)];
                for (const Entry* at = sorted_.data() + start_[std::size_t(cell)]; at != last; ++at)
                    visit(*at, at->position + shift - centre);
                column = end;
            }
        }
    }

    /// The points in the order of the cells, which is kind to the cache when all of them are visited.
    std::span<const Entry> entries() const { return sorted_; }

    /// The smaller side of a cell.
    double cell_size() const { return std::min(cell_.x, cell_.y); }
    const Domain& domain() const { return domain_; }

 private:
    struct Cells {
        long first, last;
    };
    static long floor_div(long a, long b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }
    Cells cells(double centre, double radius, double size, long count) const {
        long first = long(std::floor((centre - radius) / size));
        long last = long(std::floor((centre + radius) / size));
        if (domain_.topology == Topology::window) {
            first = std::clamp(first, 0L, count - 1);
            last = std::clamp(last, 0L, count - 1);
        }
        return {first, last};
    }

    Domain domain_;
    long columns_ = 1, rows_ = 1;
    glm::dvec2 cell_{1, 1};
    std::vector<std::uint32_t> start_;  // columns * rows + 1
    std::vector<Entry> sorted_;
};

}  // namespace dapple
