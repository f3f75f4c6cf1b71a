#include "core/image/exposure.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/maths/portable_math.h"

namespace dapple {

float usual_exposure(const Grid<float>& light) {
    constexpr float kBrightest = 1, kDark = 1.0f / 16;
    constexpr double kLeastMean = 0.09, kMostMean = 0.36, kPercentile = 0.98;
    constexpr std::size_t kSamples = 1'000'000;  // enough for percentiles

    std::vector<float> lit;
    const std::size_t step = std::max<std::size_t>(light.values.size() / kSamples, 1);
    float most = 0;
    double logarithms = 0;
    for (std::size_t i = 0; i < light.values.size(); i += step) {
        const float v = light.values[i];
        if (!(v > 0) || !std::isfinite(v)) continue;
        lit.push_back(v);
        most = std::max(most, v);
        logarithms += std::log2(v);  // quicker, and rounded to tenths in the end
    }
    if (lit.empty()) return 0;
    const auto white =
        lit.begin() + static_cast<std::ptrdiff_t>(kPercentile * static_cast<double>(lit.size() - 1));
    std::ranges::nth_element(lit, white);
    if (most <= kBrightest && *white >= kDark) return 0;

    const double mean = logarithms / static_cast<double>(lit.size());
    const double stops = std::clamp(-portable::log2(double{*white}), portable::log2(kLeastMean) - mean,
                                    portable::log2(kMostMean) - mean);
    const double limited = std::clamp<double>(stops, -kMostStops, kMostStops);
    return static_cast<float>(std::round(limited * 10) / 10);
}

Grid<float> exposed(Grid<float> light, float stops) {
    if (stops == 0) return light;
    const float gain = portable::exp2(stops);
    tbb::parallel_for(0, light.height, [&](int y) {
        float* const row = light.row(y);
        for (int x = 0; x < light.width; ++x) row[x] *= gain;
    });
    return light;
}

}  // namespace dapple
