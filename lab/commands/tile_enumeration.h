#pragma once
// Searches that look at every tile of the paper's kind, or prove that what they leave out is no better.

#include <functional>
#include <ostream>

#include "lab/commands/tile_search.h"
#include "lab/search/exhaustive_search.h"

namespace dapple {

/// Goes on with a search: continue_exhaustive_search(), or what shares it with other machines.
using ContinueSearch = std::function<SearchState(SearchState, const SearchControl&)>;

/// All tiles of TileSearchOptions::points, by relative radius. What stops goes on with --resume.
void search_by_radius(const TileSearchOptions& options, std::ostream& out,
                      const ContinueSearch& go_on = continue_exhaustive_search);

/// How long that would take: words to look at, by the floor of the last pass.
void estimate_search(int points, std::ostream& out);

/// The same by TileSearchOptions::by, a measure that lets no tile be left out.
void search_by_measure(const TileSearchOptions& options, std::ostream& out);

/// Tiles of several cycles together. There are few enough to be done before anyone waits.
void search_cycle_sets(const TileSearchOptions& options, std::ostream& out);

}  // namespace dapple
