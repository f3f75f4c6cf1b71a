#include "core/image/detail.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/image/blur.h"
#include "core/image/tone.h"

namespace dapple {

namespace {

constexpr float kGain = 1.5f, kEdge = 0.1f, kMost = 0.15f;

template <class Value>
void for_each_row(Grid<float>& grid, Value value) {
    tbb::parallel_for(0, grid.height, [&](int y) {
        float* const row = grid.row(y);
        for (int x = 0; x < grid.width; ++x) row[x] = value(row[x], x, y);
    });
}

float limited(float change) {
    return change / (1 + std::abs(change) / kMost);
}

}  // namespace

double detail_sigma(double pixels, double dots) {
    return 2 * std::sqrt(pixels / std::max(dots, 1.0));
}

Grid<float> with_detail(Grid<float> light, double amount, double sigma_px) {
    if (amount == 0 || light.empty()) return light;
    // In this order NaN becomes white.
    for_each_row(light, [](float v, int, int) { return linear_to_srgb(v < 1 ? (v > 0 ? v : 0.0f) : 1.0f); });
    const Grid<float> mean = blurred(light, sigma_px);
    Grid<float> variance = light;
    for_each_row(variance, [](float v, int, int) { return v * v; });
    variance = blurred(std::move(variance), sigma_px);
    const auto strength = static_cast<float>(amount);
    for_each_row(light, [&](float v, int x, int y) {
        const float m = mean.at(x, y), spread = std::max(0.0f, variance.at(x, y) - m * m);
        const float change = kGain * (v - m) * (kEdge * kEdge / (spread + kEdge * kEdge));
        return srgb_to_linear(std::clamp(v + strength * limited(change), 0.0f, 1.0f));
    });
    return light;
}

}  // namespace dapple
