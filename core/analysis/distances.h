#pragma once
// Nearest-neighbour distances of a point set.
//
// Distances are given over the spacing of the hexagonal lattice of the same count, 2 r_max with
// r_max = sqrt(area / (2 sqrt(3) n)): the hexagonal lattice has 1, the square lattice sqrt(sqrt(3) / 2) =
// 0.9306. The smallest of them is the relative radius (Lagae & Dutré 2006, section 5; "A Comparison of
// Methods for Generating Poisson Disk Distributions", 2008, section 4), half the smallest distance over
// r_max. White noise has a mean of 1 / (2 sqrt(density)), 0.4653 here.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"
#include "core/image/density.h"

namespace dapple {

// Points sorted into square-ish cells of about two points each, to find those near a place.

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

// How evenly a point set fills its domain on a coarse scale.

/// Points counted in a grid of equal, nearly square cells; densities are over the mean, n / area.
struct LocalDensity {
    int columns = 0, rows = 0;
    std::vector<double> relative;  // rows of `columns` values, the row of smallest y first
    double lowest = 0;
    double highest = 0;
    /// Standard deviation of the cells. White noise: 1 over the root of the mean count of a cell.
    double deviation = 0;
};

/// Cells of about `points_per_cell` points on average (> 0); one cell at least, 1024 x 1024 at most. A point
/// on a line between cells belongs to the one of greater x or y. No cells for no points. Points as
/// points_inside() gives them.
LocalDensity local_density(std::span<const glm::dvec2> points, const Domain& domain,
                           double points_per_cell = 64);

// How far apart dots keep in a picture, where they lie near each other in the dark and far apart in the
// light.

/// Distances to the nearest dot, each over the largest that all dots could have at the density where the dot
/// lies, sqrt(2 / (sqrt(3) n)) for n dots on an area of 1: a hexagonal lattice has 1.
struct LocalDistances {
    double p1 = 0;  // 1st percentile: sorted value at place (count - 1) / 100, interpolated
    double mean = 0;
    std::size_t count = 0;  // of dots judged
};

/// Dots that density 1 would put on an area of 1, when there are so many in all.
double dots_at_full_density(const Density& density, std::size_t count);

/// `full` is dots_at_full_density() or, for placed dots, kDotsPerScale * scale. Two sorts of dots are left
/// out: those where the density is below 1 %, whose distances chance decides, and those nearer to the page's
/// edge than a mean spacing, the root of the page's area over the number of dots, which have neighbours on
/// one side only. All 0 if none is left. Dots lie on the page.
LocalDistances local_distances(std::span<const glm::dvec2> dots, const Density& density, double full);

/// For every point the distance to its nearest neighbour, in the unit of the domain. On a torus the point's
/// own images count, so one point alone is a square lattice. In a window a point near the edge has neighbours
/// on one side only, and a lone point has infinity. A million evenly spread points take a fraction of a
/// second; a set that is crowded into a small part of its domain takes longer. Points as points_inside()
/// gives them. Unfinished (zeros) when a stop was requested.
std::vector<double> nearest_distances(std::span<const glm::dvec2> points, const Domain& domain,
                                      std::stop_token stop = {});

/// All over 2 r_max; all 0 if no point has a neighbour.
struct NearestSummary {
    double minimum = 0;  // the relative radius of the set
    double p1 = 0;       // 1st percentile: sorted value at place (n - 1) / 100, interpolated between two
    double mean = 0;
};

NearestSummary nearest_summary(std::span<const glm::dvec2> points, const Domain& domain,
                               std::stop_token stop = {});

}  // namespace dapple
