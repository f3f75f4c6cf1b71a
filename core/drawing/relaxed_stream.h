#pragma once
// Relaxed drawings too large to be held: the page in bands, each placed and relaxed with what lies around it.

#include <cstdint>
#include <stop_token>

#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"

namespace dapple {

/// About so many dots are relaxed at a time, with those of the rims above and below, while as many that are
/// done are handed over. It has no say in the result.
inline constexpr std::uint64_t kDotsAtOnce = 4'000'000;

/// The dots of stream(), relaxed so many times (1 or more), without holding all of them: for each pass they
/// are placed and relaxed anew, unless they fit into one band, which is kept. Row after row of the page, as
/// Relaxation gives them. The placer and the density have to outlive it; the scale, threads and stirring of
/// `relaxing` follow from the others. Throws as stream() does. If stopped, some of them, or none.
DotStream relaxed_stream(Placer& placer, const Density& density, const StreamRequest& request, int steps,
                         std::uint64_t dots_at_once = kDotsAtOnce, const std::stop_token& stop = {},
                         const RelaxingRequest& relaxing = {});

}  // namespace dapple
