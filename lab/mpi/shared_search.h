#pragma once
// The exhaustive search for tiles on many machines: rank 0 hands out the parts of each pass as the other
// ranks ask for them, with the radius that is still of interest, and takes what they found. What comes out is
// what one machine finds, to the byte.

#include "lab/search/exhaustive_search.h"

namespace dapple {

/// Goes on with a search until it is finished or stopped: as continue_exhaustive_search() of one machine, if
/// there is only one rank. To be called by rank 0; afterwards the other ranks still wait.
SearchState continue_on_ranks(SearchState state, const SearchControl& control);

/// What the other ranks do until end_ranks().
void search_for_rank_0();

/// By rank 0: the other ranks may go.
void end_ranks();

}  // namespace dapple
