#include "app/viewer/desktop/dot_limit.h"

#include <algorithm>

#include "core/drawing/settings.h"

namespace dapple {
namespace {

// A dot is five floats and four bytes of colour in the drawing shown, in the one being placed and in one kept
// for its memory; all that twice in a split view, and once more while it is saved. Relaxing one needs 44
// bytes a dot for the while. The drawing as it was has some of the other half. The graphics driver gets them
// by and by.
constexpr std::uint64_t kBytesPerDot = 250;
constexpr std::uint64_t kShare = 2;  // one part in so many is for dots
constexpr std::uint64_t kFewest = 1'000'000;

}  // namespace

std::uint64_t most_dots_in(std::uint64_t bytes) {
    return std::clamp(bytes / kShare / kBytesPerDot, kFewest, kMostDots);
}

}  // namespace dapple
