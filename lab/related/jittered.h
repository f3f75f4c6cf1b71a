#pragma once
// A jittered grid: one dot at random in each of equal cells.

#include "lab/related/wanted.h"

namespace dapple {

/// R. L. Cook, "Stochastic Sampling in Computer Graphics" (1986), section 3. There are about sqrt(count) rows
/// of equal height, whose cells differ by one in number where the count is no square. For a picture the cells
/// are those of the unit square, bent (see BentSquare). Any count.
PlainDots jittered_grid(const DotsWanted& wanted);

}  // namespace dapple
