#pragma once
// Parts of relaxed drawings. Where all dots are few enough to be held, they are relaxed together, once, and
// cut. Else the page is relaxed in bands, each with what lies around it.

#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>

#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"

namespace dapple {

/// About so many dots are relaxed at a time, with those of the rims above and below, while as many that are
/// done are handed over.
inline constexpr std::uint64_t kDotsAtOnce = 4'000'000;

/// All dots of a page, settled once a part of them is asked for.
class SettledDots {
 public:
    /// Those on the request's part. The placer and the density are needed for this call alone, the others
    /// have to be the same in all calls. None if stopped, and the next call settles anew.
    DotStream on(Placer& placer, const Density& density, const StreamRequest& request, int steps,
                 const RelaxingRequest& relaxing, const std::stop_token& stop = {});

 private:
    std::mutex mutex_;
    std::shared_ptr<const DotPieces> dots_;
    double scale_ = 0;
};

/// The displacement that dots as placed are carried by in place of warps: for drawings that are relaxed in
/// bands. `relaxing` has the scale.
std::shared_ptr<const Displacement> carried(Placer& placer, const Density& density,
                                            const PlacingRequest& placing, const RelaxingRequest& relaxing);

/// Into `relaxing`, what is the same for all parts and bands of a page.
void share_work(Placer& placer, const Density& density, const PlacingRequest& placing, int steps,
                RelaxingRequest& relaxing);

/// The dots of stream(), relaxed so many times (1 or more), without holding all of them: for each pass they
/// are placed and relaxed anew, unless they fit into one band, which is kept. Row after row of the page, as
/// Relaxation gives them. The placer and the density have to outlive it; the scale, threads and stirring of
/// `relaxing` follow from the others, and what share_work() gives, if it isn't there. Throws as stream()
/// does. If stopped, some of them, or none.
DotStream relaxed_stream(Placer& placer, const Density& density, const StreamRequest& request, int steps,
                         std::uint64_t dots_at_once = kDotsAtOnce, const std::stop_token& stop = {},
                         const RelaxingRequest& relaxing = {});

}  // namespace dapple
