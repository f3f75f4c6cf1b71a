#include "core/analysis/tone_fidelity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/image/blur.h"

namespace dapple {
namespace {

constexpr double kC1 = 0.01 * 0.01;  // (K1 peak)^2
constexpr double kC2 = 0.03 * 0.03;
constexpr double kWindow = 1.5;
constexpr double kSmallestError = 1e-10;

template <class Value>
Grid<float> windowed(int width, int height, double sigma, const Value& value) {
    Grid<float> grid(width, height);
    for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = static_cast<float>(value(i));
    return blurred(std::move(grid), sigma);
}

double mean_ssim(const Grid<float>& a, const Grid<float>& b, double sigma) {
    const auto window = [&](const auto& value) { return windowed(a.width, a.height, sigma, value); };
    const Grid<float> mean_a = blurred(a, sigma), mean_b = blurred(b, sigma);
    const Grid<float> aa = window([&](std::size_t i) { return double(a.values[i]) * a.values[i]; });
    const Grid<float> bb = window([&](std::size_t i) { return double(b.values[i]) * b.values[i]; });
    const Grid<float> ab = window([&](std::size_t i) { return double(a.values[i]) * b.values[i]; });
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = std::max(0.0, aa.values[i] - ma * ma);
        const double variance_b = std::max(0.0, bb.values[i] - mb * mb);
        const double covariance = ab.values[i] - ma * mb;
        sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
               ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
    }
    return sum / double(a.values.size());
}

}  // namespace

double viewing_distance(double sigma) {
    return sigma / std::tan(kEyeBlurDegrees * std::numbers::pi / 180);
}

ToneFidelity tone_fidelity(const Grid<float>& drawing, const Grid<float>& photograph, double sigma_px) {
    if (drawing.width != photograph.width || drawing.height != photograph.height) {
        throw std::runtime_error(fmt::format(
            "a drawing of {} x {} pixels and a photograph of {} x {} cannot be compared; draw it in "
            "the photograph's size",
            drawing.width, drawing.height, photograph.width, photograph.height));
    }
    ToneFidelity result{.sigma_px = sigma_px};
    if (drawing.empty()) return result;

    Grid<float> cut = photograph;
    for (float& light : cut.values) light = std::clamp(light, 0.0f, 1.0f);
    const Grid<float> a = blurred(drawing, sigma_px);
    const Grid<float> b = blurred(std::move(cut), sigma_px);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double difference = double(a.values[i]) - b.values[i];
        sum += difference;
        squares += difference * difference;
    }
    const double n = double(a.values.size());
    result.mean_error = sum / n;
    result.rms_error = std::sqrt(squares / n);
    result.psnr_db = -20 * std::log10(std::max(result.rms_error, kSmallestError));
    result.ssim = mean_ssim(a, b, kWindow * std::max(1.0, sigma_px));
    return result;
}

}  // namespace dapple
