#include "core/image/ink_use.h"

#include <utility>

#include "core/image/ink.h"

namespace dapple {

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

}  // namespace dapple
