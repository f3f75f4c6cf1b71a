#pragma once
// A tile's seams: even black drawn with it, and the bare paper along the borders of its copies.

#include "core/output/seams.h"
#include "core/placing/stipple.h"

namespace dapple {

/// The dots' area over the page's, at which seams of tiles are compared: about the black of a drawing.
inline constexpr double kSeamLoad = 1.6;

/// The tile's first full level of at least so many dots: N times a power of 4.
std::size_t full_level(const RankedTile& tile, std::size_t fewest_dots);

/// The seams of the first full level of 40,000 dots or more as they are placed, before any relaxation. Takes
/// about half a second.
Seams seams_on_black(RankedTile& tile);

}  // namespace dapple
