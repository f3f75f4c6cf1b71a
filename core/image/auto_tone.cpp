#include "core/image/auto_tone.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/image/ink.h"
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

namespace {

// The density for each bin's value, through the very function that drawings go through.
Grid<float> density_of_bins(Tone tone, const InkCurve& ink = InkCurve()) {
    Grid<float> greys(Histogram::kSteps + 1, 1);
    for (int i = 0; i < greys.width; ++i) greys.at(i, 0) = srgb_to_linear(Histogram::value_of(i));
    tone.blur = 0;
    return density_of(std::move(greys), tone, ink);
}

bool is_nearly_black(int bin, const Tone& tone) {
    constexpr float kNearlyBlack = 0.2f;
    return Histogram::value_of(bin) <=
           tone.black_point + kNearlyBlack * (tone.white_point - tone.black_point);
}

}  // namespace

double mean_ink(const Histogram& histogram, const Tone& tone) {
    if (histogram.total == 0) return 0;
    const Grid<float> density = density_of_bins(tone);
    const InkCurve ink;
    double sum = 0;
    for (int i = 0; i < density.width; ++i)
        sum += static_cast<double>(histogram.counts[i]) * ink.coverage(density.at(i, 0));
    return sum / static_cast<double>(histogram.total);
}

double mean_density(const Histogram& histogram, const Tone& tone, const InkCurve& ink) {
    if (histogram.total == 0) return 0;
    const Grid<float> density = density_of_bins(tone, ink);
    double sum = 0;
    for (int i = 0; i < density.width; ++i)
        sum += static_cast<double>(histogram.counts[i]) * density.at(i, 0);
    return sum / static_cast<double>(histogram.total);
}

double dots_in_black(const Histogram& histogram, const Tone& tone) {
    const Grid<float> density = density_of_bins(tone);
    double all = 0, black = 0;
    for (int i = 0; i < density.width; ++i) {
        const double dots = static_cast<double>(histogram.counts[i]) * density.at(i, 0);
        all += dots;
        if (is_nearly_black(i, tone)) black += dots;
    }
    return all > 0 ? black / all : 0;
}

bool mostly_black(const Histogram& histogram, const Tone& tone) {
    constexpr double kMostDots = 0.9, kMostPixels = 0.7;
    if (tone.invert) return false;
    std::uint64_t black = 0;
    for (int i = 0; i <= Histogram::kSteps; ++i)
        if (is_nearly_black(i, tone)) black += histogram.counts[i];
    return static_cast<double>(black) > kMostPixels * static_cast<double>(histogram.total) &&
           dots_in_black(histogram, tone) >= kMostDots;
}

namespace {

constexpr float kGamma = 2.2f;
constexpr float kLeastGamma = kGamma / 1.6f, kMostGamma = kGamma / 0.6f;
constexpr double kBalance = 0.42, kLeastInk = 0.30, kMostInk = 0.62;

struct Levels {
    float black, white;
};

std::optional<Levels> levels_of(const Histogram& histogram, bool invert) {
    constexpr float kOneTone = 0.02f, kLeastRange = 0.12f, kReach = 0.35f, kPaperRange = 0.15f;
    float black = std::min(percentile(histogram, 0.5), percentile(histogram, 0.01) + kReach);
    float white = std::max(percentile(histogram, 99.5), percentile(histogram, 99.99) - kReach);
    if (white - black < kOneTone) return std::nullopt;
    // The far side of the paper's noise, and half as far again.
    if (invert) {
        const float paper = percentile(histogram, 70) - black;
        if (paper < kPaperRange * (white - black)) black += 1.5f * paper;
    } else {
        const float paper = white - percentile(histogram, 30);
        if (paper < kPaperRange * (white - black)) white -= 1.5f * paper;
    }
    const float middle = (black + white) / 2;
    if (white - black < kLeastRange) {
        black = std::clamp(middle - kLeastRange / 2, 0.0f, 1 - kLeastRange);
        white = black + kLeastRange;
    }
    return Levels{black, white};
}

// Less where a picture is nearly all black: only noise would be lightened.
float most_gamma(double ink) {
    constexpr double kDark = 0.85, kNight = 0.97;
    const auto night = static_cast<float>(std::clamp((ink - kDark) / (kNight - kDark), 0.0, 1.0));
    return kMostGamma + (kGamma - kMostGamma) * night;
}

}  // namespace

Tone auto_tone(const Histogram& histogram, const Tone& own, double strength) {
    const Tone neutral;
    Tone tone = own;
    tone.black_point = neutral.black_point;
    tone.white_point = neutral.white_point;
    tone.gamma = neutral.gamma;
    const std::optional<Levels> levels = levels_of(histogram, own.invert);
    if (!levels) return tone;
    Tone plain{.black_point = levels->black, .white_point = levels->white, .invert = own.invert};
    const auto ink = [&](float gamma) {
        plain.gamma = gamma;
        return mean_ink(histogram, plain);
    };
    const double even = ink(kGamma);
    const double target = std::clamp((even + kBalance) / 2, kLeastInk, kMostInk);
    float low = kLeastGamma, high = own.invert ? kGamma : most_gamma(even);
    // More gamma is more light: less dark ink, more light ink.
    for (int i = 0; i < 14; ++i) {
        const float middle = (low + high) / 2;
        const bool too_light = own.invert ? ink(middle) > target : ink(middle) < target;
        (too_light ? high : low) = middle;
    }
    const auto share = static_cast<float>(strength);
    tone.black_point = share * levels->black;
    tone.white_point = 1 + share * (levels->white - 1);
    tone.gamma = portable::pow((low + high) / 2, share);
    return tone;
}

}  // namespace dapple
