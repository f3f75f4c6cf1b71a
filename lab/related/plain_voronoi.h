#pragma once
// Voronoi cells of dots and what they weigh: exact, and not made for speed.

#include <glm/vec2.hpp>
#include <vector>

#include "core/analysis/domain.h"
#include "core/image/density.h"

namespace dapple {

enum class LloydWeight {
    density,          // as Secord has it; dots then tend to the density's square root
    density_squared,  // dots tend to the density
};

/// Integrals over a dot's cell, of positions seen from the dot. All 0 for a dot in the place of an earlier
/// one.
struct CellMoments {
    double weight = 0;
    glm::dvec2 first{};             // weight times the way to the centroid
    double xx = 0, xy = 0, yy = 0;  // second moments
    double area = 0;                // of the cell, whatever it weighs
};

/// The cell of each dot within the page: the weight integrated over triangles no longer than a pixel of the
/// density, exactly where it is constant. Cells are exact polygons. Uses all cores; the result is the same
/// for any number.
std::vector<CellMoments> weighted_cells(const std::vector<glm::dvec2>& dots, const Density& density,
                                        LloydWeight weight);

/// The same for weight 1; without a domain on the unit square, whose opposite edges meet.
std::vector<CellMoments> plain_cells(const std::vector<glm::dvec2>& dots, const Domain& domain = {});

}  // namespace dapple
