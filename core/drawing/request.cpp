#include "core/drawing/request.h"

#include <algorithm>
#include <cmath>

namespace dapple {

double reach_mm(const DotSize& size) {
    if (size.sizing == DotSizing::automatic) return 0;
    return size.sizing == DotSizing::fixed ? size.radius_mm : size.largest_mm;
}

namespace {

constexpr double kSeenMm = 0.1;        // between dots, at reading distance
constexpr double kNoWait = 2'000'000;  // dots
// Few dots have to show a picture with what evenness they can get, and their steps take no time.
constexpr double kFew = 12'800, kMany = 80'000;

}  // namespace

int usual_steps(double dots, double picture_area_mm2) {
    const bool unseen = std::sqrt(picture_area_mm2 / std::max(dots, 1.0)) < kSeenMm;
    if (unseen && dots > kNoWait) return 0;
    return static_cast<int>(
        std::lround(kFewestUsualSteps * std::sqrt(kMany / std::clamp(dots, kFew, kMany))));
}

}  // namespace dapple
