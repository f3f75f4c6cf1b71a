#pragma once
// Poisson's equation on a page's cells.

#include <glm/vec2.hpp>

#include "core/image/grid.h"

namespace dapple {

/// About so many cells along a length, a number that can be halved often: of cells that are about 1 long.
int cells_along(double length);

/// phi with laplace(phi) = excess, through whose edges nothing flows: by cycles of multigrid (Brandt 1977).
/// Cells have that size, and the excess sums to 0 or nearly. The same bits for any number of threads.
Grid<float> poisson(Grid<float> excess, glm::vec2 cell, int cycles = 2);

}  // namespace dapple
