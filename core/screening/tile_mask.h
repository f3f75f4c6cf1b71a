#pragma once
// Masks whose order is a self-similar tile's: a pixel is inked when the first dot of an endless subdivision
// falls into it.

#include "core/placing/stipple.h"
#include "core/screening/threshold_mask.h"

namespace dapple {

/// A square mask, `side` pixels wide (4..2048), whose edges meet as those of the tile do. Throws
/// std::runtime_error if the side is out of its range.
ThresholdMask tile_mask(RankedTile& tile, int side);

}  // namespace dapple
