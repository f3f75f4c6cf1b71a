#pragma once
// Searches for even tiles by annealing, which goes on as long as one likes.

#include <cstdint>
#include <ostream>

#include "app/commands/tile_search.h"

namespace dapple {

/// Tried without --moves or --seconds.
inline constexpr std::uint64_t kMovesPerPoint = 10'000;

/// Tiles whose copies are turned, by TileSearchOptions::rule.
void search_turned(const TileSearchOptions& options, std::ostream& out);

/// A tile of several kinds.
void search_kinds(const TileSearchOptions& options, std::ostream& out);

}  // namespace dapple
