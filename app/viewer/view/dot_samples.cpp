#include "app/viewer/view/dot_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace dapple {
namespace {

// A dot's radius, in samples. From kSmoothRadius on its edge is a sample wide and looks smooth by itself;
// below it the edge is harder (dot.vert), and kSmoothSamples samples a side make it smooth. From
// kSmallestRadius on a dot shows its shape.
constexpr double kSmoothRadius = 6, kSmoothSamples = 3;
constexpr double kSmallestRadius = 1.5;
// A page of few pixels has dots far below a sample's size, of which some meet one and others none. They are
// right on average, and this is enough of an average. Some drivers also end loops after 65,535 rounds.
constexpr double kMostPerSide = 128;
constexpr double kQuickSamples = 2.5e6;

}  // namespace

int samples_per_side(double dot_radius, glm::ivec2 pixels, Fineness fineness, const SampleLimits& limits) {
    const glm::dvec2 size(glm::max(pixels, 1));
    const double most = fineness == Fineness::quick ? std::min(kQuickSamples, limits.most) : limits.most;
    const double allowed =
        std::min(std::sqrt(most / (size.x * size.y)), limits.largest_side / std::max(size.x, size.y));
    const double smooth = std::min(std::ceil(kSmoothRadius / dot_radius), kSmoothSamples);
    const double wanted = std::clamp(std::ceil(kSmallestRadius / dot_radius), smooth, kMostPerSide);
    return static_cast<int>(std::max(std::min(wanted, std::floor(allowed)), 1.0));
}

}  // namespace dapple
