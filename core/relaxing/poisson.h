#pragma once
// Poisson's equation on a page's cells.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/vec2.hpp>

#include "core/image/grid.h"

namespace dapple {

/// Calls body(row) for each row of cells, some of them at a time on a thread.
template <class Body>
void for_each_row(int rows, const Body& body) {
    constexpr int kAtOnce = 16;
    tbb::parallel_for(0, (rows + kAtOnce - 1) / kAtOnce, [&](int stretch) {
        for (int y = stretch * kAtOnce; y < std::min((stretch + 1) * kAtOnce, rows); ++y) body(y);
    });
}

/// About so many cells along a length, a number that can be halved often: of cells that are about 1 long.
int cells_along(double length);

/// phi with laplace(phi) = excess, through whose edges nothing flows: by cycles of multigrid (Brandt 1977).
/// Cells have that size, and the excess sums to 0 or nearly. The same bits for any number of threads.
Grid<float> poisson(Grid<float> excess, glm::vec2 cell, int cycles = 2);

}  // namespace dapple
