#pragma once
// Searches for even tiles by annealing, which goes on as long as one likes.

#include <cstdint>
#include <ostream>

#include "lab/commands/tile_search.h"
#include "lab/search/kind_search.h"

namespace dapple {

/// Tried without --moves or --seconds.
inline constexpr std::uint64_t kMovesPerPoint = 10'000;

/// Tiles whose copies are turned, by TileSearchOptions::rule.
void search_turned(const TileSearchOptions& options, std::ostream& out);

/// One of several searches that go on side by side: see KindSearchSettings.
struct IslandSearch {
    int island = 0, islands = 1;
    BestIsland best = {};
};

/// A tile of several kinds. Of islands the first one saves what all of them found, and tells it.
void search_kinds(const TileSearchOptions& options, std::ostream& out, const IslandSearch& side_by_side = {});

}  // namespace dapple
