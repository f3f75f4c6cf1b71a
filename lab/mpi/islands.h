#pragma once
// The search for a tile of several kinds on many machines: each rank is an island, which goes on from the
// best of all again and again. The same seed, moves and ranks, the same tile.

#include <ostream>

#include "lab/commands/tile_search.h"

namespace dapple {

/// Called by all ranks; `out` is rank 0's. Throws on rank 0 alone if the tile cannot be saved.
void search_kinds_on_ranks(const TileSearchOptions& options, std::ostream& out);

}  // namespace dapple
