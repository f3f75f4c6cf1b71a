#include "core/image/histogram.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "core/image/tone.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

// The encoded value times Histogram::kSteps, from a table over the square root of light, along which the
// transfer function bends least: a power for each pixel would take ten times as long.
class EncodedSteps {
 public:
    explicit EncodedSteps(float exposure) : gain_(portable::exp2(exposure)) {
        for (int i = 0; i <= kRoots; ++i) {
            const float root = static_cast<float>(i) / kRoots;
            steps_[i] = linear_to_srgb(root * root) * Histogram::kSteps;
        }
        steps_[kRoots + 1] = steps_[kRoots];
    }

    float operator()(float light) const {
        // In this order NaN becomes white.
        const float seen = light * gain_;
        const float at_most_1 = seen < 1 ? seen : 1.0f;
        const float at = std::sqrt(at_most_1 > 0 ? at_most_1 : 0.0f) * kRoots;
        const int i = static_cast<int>(at);
        return steps_[i] + (steps_[i + 1] - steps_[i]) * (at - static_cast<float>(i));
    }

 private:
    static constexpr int kRoots = 4096;
    float gain_;
    std::array<float, kRoots + 2> steps_;
};

struct Part {
    int left, top, right, bottom;  // right and bottom are one past the last
};

// The picture without its frame.
Part within_frame(const Grid<float>& light, const EncodedSteps& steps) {
    const Part all{0, 0, light.width, light.height};
    const float corner = steps(light.at(0, 0));
    constexpr float kTolerance = 2.5f * Histogram::kSteps / 255;
    const auto is_frame = [&](int x, int y) { return std::abs(steps(light.at(x, y)) - corner) < kTolerance; };
    Part part = all;
    const auto row_is_frame = [&](int y) {
        for (int x = 0; x < light.width; ++x)
            if (!is_frame(x, y)) return false;
        return true;
    };
    const auto column_is_frame = [&](int x) {
        for (int y = part.top; y < part.bottom; ++y)
            if (!is_frame(x, y)) return false;
        return true;
    };
    while (part.top < part.bottom && row_is_frame(part.top)) ++part.top;
    if (part.top == part.bottom) return all;
    while (row_is_frame(part.bottom - 1)) --part.bottom;
    while (column_is_frame(part.left)) ++part.left;
    while (column_is_frame(part.right - 1)) --part.right;

    // A narrow strip is more likely the beginning of a sky or of a gradient.
    const auto is_narrow = [](int strip, int side) { return strip < std::max(2, side / 50); };
    if (is_narrow(part.left, all.right)) part.left = 0;
    if (is_narrow(all.right - part.right, all.right)) part.right = all.right;
    if (is_narrow(part.top, all.bottom)) part.top = 0;
    if (is_narrow(all.bottom - part.bottom, all.bottom)) part.bottom = all.bottom;
    return part;
}

}  // namespace

Histogram histogram_of(const Grid<float>& light, float exposure) {
    if (light.empty()) return {};
    const EncodedSteps steps(exposure);
    const Part part = within_frame(light, steps);
    const auto count = [&](const tbb::blocked_range<int>& rows, Histogram histogram) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const float* const row = light.row(y);
            for (int x = part.left; x < part.right; ++x)
                ++histogram.counts[static_cast<int>(steps(row[x]) + 0.5f)];
        }
        histogram.total += static_cast<std::uint64_t>(rows.size()) * (part.right - part.left);
        return histogram;
    };
    const auto sum = [](Histogram a, const Histogram& b) {
        for (int i = 0; i <= Histogram::kSteps; ++i) a.counts[i] += b.counts[i];
        a.total += b.total;
        return a;
    };
    // Bands of rows, as every one carries its own counts.
    return tbb::parallel_reduce(tbb::blocked_range<int>(part.top, part.bottom, 64), Histogram{}, count, sum);
}

float percentile(const Histogram& histogram, double percent) {
    const double share = std::clamp(percent, 0.0, 100.0) / 100;
    const auto rank = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(histogram.total))));
    std::uint64_t below = 0;
    for (int i = 0; i <= Histogram::kSteps; ++i) {
        below += histogram.counts[i];
        if (below >= rank) return Histogram::value_of(i);
    }
    return 0;
}

}  // namespace dapple
