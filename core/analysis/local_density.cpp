#include "core/analysis/local_density.h"

#include <algorithm>
#include <cmath>

namespace dapple {

LocalDensity local_density(std::span<const glm::dvec2> points, const Domain& domain, double points_per_cell) {
    LocalDensity result;
    if (points.empty()) return result;
    const double n = double(points.size());
    const double side = std::sqrt(domain.area() * points_per_cell / n);
    result.columns = int(std::clamp(std::round(domain.width / side), 1.0, 1024.0));
    result.rows = int(std::clamp(std::round(domain.height / side), 1.0, 1024.0));
    result.relative.resize(std::size_t(result.columns) * std::size_t(result.rows));

    const double cells = double(result.relative.size());
    for (const glm::dvec2 p : points) {
        const int column = std::min(int(p.x / domain.width * result.columns), result.columns - 1);
        const int row = std::min(int(p.y / domain.height * result.rows), result.rows - 1);
        result.relative[std::size_t(row) * std::size_t(result.columns) + std::size_t(column)] += 1;
    }
    double squares = 0;
    for (double& density : result.relative) {
        density *= cells / n;
        squares += (density - 1) * (density - 1);
    }
    const auto [lowest, highest] = std::minmax_element(result.relative.begin(), result.relative.end());
    result.lowest = *lowest;
    result.highest = *highest;
    result.deviation = std::sqrt(squares / cells);
    return result;
}

}  // namespace dapple
