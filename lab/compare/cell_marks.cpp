#include "lab/compare/cell_marks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lab/related/plain_voronoi.h"

namespace dapple {

CellMarks cell_marks(const PlainDots& dots, const Density& density) {
    if (dots.empty()) return {};
    double weight = 0, squares = 0, energy = 0, displacement = 0;
    for (const CellMoments& cell : weighted_cells(dots, density, LloydWeight::density)) {
        weight += cell.weight;
        squares += cell.weight * cell.weight;
        energy += cell.xx + cell.yy;
        if (cell.weight > 0) displacement += glm::length(cell.first / cell.weight);
    }
    if (weight <= 0) return {};
    const double count = double(dots.size()), mean = weight / count;
    const glm::dvec2 page = page_of({.density = &density});
    const double share = page.x * page.y / count;
    return {energy / weight / share, std::sqrt(std::max(squares / count / (mean * mean) - 1, 0.0)),
            displacement / count / std::sqrt(share)};
}

}  // namespace dapple
