#pragma once
// The paper's placer as printed (Lagae & Dutré 2006, Figure 8): the reference, the baseline and a mode of the
// viewer.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/image/density.h"
#include "core/placing/dots.h"
#include "core/placing/placer.h"
#include "core/tile/tile.h"

namespace dapple {

struct Figure8Result {
    Dots dots;                      // as emitted, duplicates included
    double scale = 0;               // they were placed at
    std::uint64_t duplicates = 0;   // dots emitted again at a place that has one
    std::vector<PlacedTile> tiles;  // every tile visited, parents first
};

/// Recursive, in double precision; decides about subdivision at the tile's N points and tests inherited
/// points again. ranks: each point's place in the tile's own order, from farthest_point_ranks(). Throws
/// std::runtime_error if the tile's rule is not the identity: the paper knows no other. Stopped, it returns
/// what it has so far.
Figure8Result place_figure8(const Density& density, const Tile& tile, const std::vector<int>& ranks,
                            double scale, const std::stop_token& stop = {});

/// The same at a scale that has so many distinct dots, or a few more: how many a scale has is known once they
/// are placed. Nothing if stopped. Throws std::runtime_error as above, and if so many are not found, or only
/// with far more: what a tile's points miss is lost.
std::optional<Figure8Result> place_figure8_count(const Density& density, const Tile& tile,
                                                 const std::vector<int>& ranks, std::uint64_t count,
                                                 const std::stop_token& stop = {});

}  // namespace dapple
