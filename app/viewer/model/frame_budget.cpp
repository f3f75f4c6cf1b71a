#include "app/viewer/model/frame_budget.h"

#include <algorithm>

namespace dapple {

double FrameBudget::seconds(double most) const {
    return std::clamp(kFrameSeconds - other_, kLeastSeconds, std::max(most, kLeastSeconds));
}

void FrameBudget::learn(double frame, double drawing) {
    const double other = std::max(frame - drawing, 0.0);
    // Quickly to less, slowly to more: one short frame says little about the next.
    other_ += (other > other_ ? 0.5 : 0.1) * (other - other_);
}

}  // namespace dapple
