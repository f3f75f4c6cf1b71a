#include "core/image/ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dapple {

namespace {

constexpr float kLoadStep = 0.1f;
constexpr std::array<float, 17> kCoverage{0.0f,    0.0998f, 0.1990f, 0.2984f, 0.3961f, 0.4895f,
                                          0.5760f, 0.6547f, 0.7241f, 0.7838f, 0.8342f, 0.8753f,
                                          0.9087f, 0.9343f, 0.9543f, 0.9689f, 0.9794f};

}  // namespace

float coverage_of_load(float load) {
    const float at = std::clamp(load / kLoadStep, 0.0f, static_cast<float>(kCoverage.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(at), kCoverage.size() - 2);
    return kCoverage[i] + (kCoverage[i + 1] - kCoverage[i]) * (at - static_cast<float>(i));
}

float load_of_coverage(float coverage) {
    const auto above = std::upper_bound(kCoverage.begin(), kCoverage.end(), coverage);
    if (above == kCoverage.begin()) return 0;
    if (above == kCoverage.end()) return kFullLoad;
    const float low = *(above - 1), high = *above;
    return kLoadStep * (static_cast<float>(above - 1 - kCoverage.begin()) + (coverage - low) / (high - low));
}

double radius_for_tone(double scale) {
    // At density 1 there are 16 * scale dots on a root square of area 1.
    return std::sqrt(kFullLoad / (std::numbers::pi * 16 * std::max(scale, 1e-12)));
}

}  // namespace dapple
