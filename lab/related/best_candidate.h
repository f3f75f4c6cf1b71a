#pragma once
// Best candidate: each new dot is the one of several that lies farthest from all before it.

#include "lab/related/wanted.h"

namespace dapple {

/// D. P. Mitchell, "Spectrally Optimal Sampling for Distribution Ray Tracing" (1991): the dot of number i is
/// the best of i candidates (his m = 1), so all take count^2 / 2 searches; some ten seconds for 20,000 dots.
/// For a picture candidates have its density, and distances count times the root of it. Every prefix is a
/// drawing.
PlainDots best_candidate(const DotsWanted& wanted);

}  // namespace dapple
