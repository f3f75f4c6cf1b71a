#include "lab/analysis/ssim.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/image/detail.h"

namespace dapple {
namespace {

constexpr double kC1 = 0.01 * 0.01;  // (K1 peak)^2
constexpr double kC2 = 0.03 * 0.03;

template <class Value>
Grid<float> windowed(int width, int height, double sigma, const Value& value) {
    Grid<float> grid(width, height);
    for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = static_cast<float>(value(i));
    return blurred(std::move(grid), sigma);
}

}  // namespace

Grid<float> ssim_map(const Grid<float>& a, const Grid<float>& b, double sigma) {
    assert(a.width == b.width && a.height == b.height);
    if (a.empty()) return {};
    const auto window = [&](const auto& value) { return windowed(a.width, a.height, sigma, value); };
    const Grid<float> mean_a = blurred(a, sigma), mean_b = blurred(b, sigma);
    const Grid<float> aa = window([&](std::size_t i) { return double(a.values[i]) * a.values[i]; });
    const Grid<float> bb = window([&](std::size_t i) { return double(b.values[i]) * b.values[i]; });
    const Grid<float> ab = window([&](std::size_t i) { return double(a.values[i]) * b.values[i]; });
    Grid<float> map(a.width, a.height);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = std::max(0.0, aa.values[i] - ma * ma);
        const double variance_b = std::max(0.0, bb.values[i] - mb * mb);
        const double covariance = ab.values[i] - ma * mb;
        map.values[i] = static_cast<float>((2 * ma * mb + kC1) * (2 * covariance + kC2) /
                                           ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2)));
    }
    return map;
}

double mean_ssim(const Grid<float>& a, const Grid<float>& b, double sigma) {
    if (a.empty()) return 0;
    const Grid<float> map = ssim_map(a, b, sigma);
    return std::accumulate(map.values.begin(), map.values.end(), 0.0) / double(map.values.size());
}

}  // namespace dapple
