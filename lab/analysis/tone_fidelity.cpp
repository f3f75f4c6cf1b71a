#include "lab/analysis/tone_fidelity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/image/detail.h"
#include "lab/analysis/ssim.h"

namespace dapple {
namespace {

constexpr double kWindow = 1.5;
constexpr double kSmallestError = 1e-10;

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
