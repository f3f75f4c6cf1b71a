#pragma once
// What a drawing needs beside its dots, for the window and the command line alike.

#include <vector>

#include "core/stipple.h"

namespace dapple {

/// The tiles that a placer goes through at that scale: those that Figure 8 visits, or the exact placer's.
std::vector<PlacedTile> tiles_of(RankedTile& tile, const Density& density, PlacerKind placer, double scale);

}  // namespace dapple
