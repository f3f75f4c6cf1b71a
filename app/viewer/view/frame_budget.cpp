#include "app/viewer/view/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

// Seconds, measured where Mesa draws with one processor. A graphics card is so much faster that nearly always
// all dots are drawn, whatever its own proportion is.
constexpr double kPerDot = 7e-7, kPerSample = 2.4e-9;

// The samples of a square around each dot and its soft edge; the radius in samples.
double samples_of(double dots, double radius) {
    const double side = 2 * (radius + 1);
    return dots * side * side;
}

}  // namespace

double FrameBudget::seconds(double most) const {
    return std::clamp(kFrameSeconds - other_, kLeastSeconds, std::max(most, kLeastSeconds));
}

void FrameBudget::learn(double frame, double drawing) {
    const double other = std::max(frame - drawing, 0.0);
    // Quickly to less, slowly to more: one short frame says little about the next.
    other_ += (other > other_ ? 0.5 : 0.1) * (other - other_);
}

double DotCost::seconds(double dots, double radius) const {
    return slowness_ * (kPerDot * dots + kPerSample * samples_of(dots, radius));
}

void DotCost::learn(double dots, double radius, double seconds) {
    slowness_ *= (1 + std::max(seconds / this->seconds(dots, radius), 0.01)) / 2;
}

std::size_t DotCost::every(std::size_t dots, double radius, double seconds, std::size_t before) const {
    constexpr double kWorthIt = 0.7;
    const std::size_t most = dots / std::max(std::min(dots / 2, kEnoughDots), kFewestDots);
    if (most <= 1) return 1;
    const auto count = static_cast<double>(dots);
    const double all = this->seconds(count, radius);
    if (all <= seconds) return std::min(before, most);
    const double covering = slowness_ * kPerSample * samples_of(count, radius);
    // Fewer dots than those would gain little.
    const double room = std::max(seconds - covering, covering);
    const double every = std::min(std::ceil(count * slowness_ * kPerDot / room), static_cast<double>(most));
    const bool worth_it = this->seconds(count / every, radius * std::sqrt(every)) < kWorthIt * all;
    return std::max(worth_it ? static_cast<std::size_t>(every) : 1, std::min(before, most));
}

}  // namespace dapple
