#pragma once
// How even and how periodic constant grey is, on the unit square whose opposite edges meet.

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/analysis/distances.h"
#include "core/relaxing/energy_steps.h"

namespace dapple {

struct DotMarks {
    double highest_bin = 0, top_share = 0;  // see Peaks
    double power_03 = 0, power_05 = 0;      // mean below 0.3 and 0.5, over sqrt(n)
    NearestSummary nearest;
    double seam = 0;                            // the worst of seams()
    double structure_01 = 0, structure_03 = 0;  // the structure factor's mean from 0.03 to 0.1, to 0.3
};

/// The marks of dots that in black have an area of `load` pages together.
DotMarks dot_marks(const std::vector<glm::dvec2>& points, double load);

/// The dots stirred as before relaxing (core/relaxing/stir.h), in the same order. `scale` is a sixteenth of
/// their number.
std::vector<glm::dvec2> stirred_on_torus(const std::vector<glm::dvec2>& points, double scale);

/// The dots after so many steps of relaxation as a drawing has them, in the same order: with copies of them
/// around, as far as these have an influence.
std::vector<glm::dvec2> relaxed_on_torus(const std::vector<glm::dvec2>& points, double scale, int steps,
                                         float kernel = kPictureKernel);

/// The share of the dots that meet another when all are moved by whole tiles of this side, chance taken off:
/// the worst of all moves up to eight tiles. At least 2 tiles lie side by side.
double coincidence(const std::vector<glm::dvec2>& points, double tile_side);

}  // namespace dapple
