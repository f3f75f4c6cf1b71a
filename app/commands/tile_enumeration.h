#pragma once
// Searches that look at every tile of the paper's kind, or prove that what they leave out is no better.

#include <ostream>

#include "app/commands/tile_search.h"

namespace dapple {

/// All tiles of TileSearchOptions::points, by relative radius. What stops goes on with --resume.
void search_by_radius(const TileSearchOptions& options, std::ostream& out);

/// The same by TileSearchOptions::by, a measure that lets no tile be left out.
void search_by_measure(const TileSearchOptions& options, std::ostream& out);

/// Tiles of several cycles together. There are few enough to be done before anyone waits.
void search_cycle_sets(const TileSearchOptions& options, std::ostream& out);

}  // namespace dapple
