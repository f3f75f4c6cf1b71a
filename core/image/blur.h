#pragma once
// Gaussian blur of a grid.

#include "core/image/grid.h"

namespace dapple {

/// Blurs with a Gaussian of standard deviation sigma pixels (>= 0; 0 changes nothing), the edge pixels going
/// on outside. Three running means, whose cost does not depend on sigma (Wells 1986), within 3 % of a
/// Gaussian.
Grid<float> blurred(Grid<float> grid, double sigma);

}  // namespace dapple
