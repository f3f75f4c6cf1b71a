#pragma once
// Error diffusion: each pixel in turn becomes a dot or none, and its error goes to the pixels after it.

#include <cstdint>

#include "core/image/grid.h"
#include "lab/related/wanted.h"

namespace dapple {

/// R. W. Floyd & L. Steinberg, "An Adaptive Algorithm for Spatial Greyscale" (1976): rows from the left to
/// the right; a pixel is 1 where its value with the errors is over 1/2, and the error goes 7/16 to the right,
/// 3/16, 5/16, 1/16 below. What would leave the picture is lost.
Grid<std::uint8_t> error_diffused(Grid<float> values);

/// So many pixels to a dot of black: dots are then discs over pixels, as in the other methods' drawings.
inline constexpr double kPixelsPerBlackDot = 3;

/// Dots are the middles of its pixels, of which black has kPixelsPerBlackDot to a dot. The count is met to
/// about one in a hundred. Constant: a grey of one over that.
PlainDots floyd_steinberg(const DotsWanted& wanted);

}  // namespace dapple
