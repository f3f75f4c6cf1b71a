#pragma once
// How evenly a point set fills its domain on a coarse scale.

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

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

}  // namespace dapple
