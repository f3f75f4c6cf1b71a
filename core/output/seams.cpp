#include "core/output/seams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/output/raster_of_dots.h"

namespace dapple {
namespace {

constexpr double kPixelsPerSpacing = 12;
constexpr double kHalfStrip = 1.0 / 3;  // spacings

class MeanBare {
 public:
    explicit MeanBare(const Grid<float>& coverage, int margin) : coverage_(coverage), margin_(margin) {}

    // The mean over the pixels that `takes` wants.
    template <class Takes>
    double where(const Takes& takes) const {
        double sum = 0, pixels = 0;
        for (int y = margin_; y < coverage_.height - margin_; ++y) {
            for (int x = margin_; x < coverage_.width - margin_; ++x) {
                if (!takes(x, y)) continue;
                sum += 1 - coverage_.at(x, y);
                ++pixels;
            }
        }
        return pixels > 0 ? sum / pixels : 0;
    }

 private:
    const Grid<float>& coverage_;
    int margin_;
};

}  // namespace

double Seams::worst() const {
    return std::max({of_halves, of_quarters, of_eighths});
}

Seams seams(std::span<const glm::dvec2> dots, double load) {
    const double spacing = 1 / std::sqrt(double(dots.size()));
    // A multiple of 8, so that borders lie between pixels.
    const int side = 8 * int(std::ceil(kPixelsPerSpacing / spacing / 8));
    const double radius = std::sqrt(load / (std::numbers::pi * double(dots.size())));
    const Grid<float> coverage = raster_of_dots(dots, radius, {side, side, double(side)});
    const MeanBare bare(coverage, int(std::ceil(spacing * side)));
    Seams result{.bare = bare.where([](int, int) { return true; })};
    if (result.bare == 0) return result;

    const auto seam = [&](int tiles) {
        const int period = side / tiles;
        const double reach = kHalfStrip * spacing * side;
        const auto near_border = [&](int pixel) {
            const double from_border = pixel % period + 0.5;
            return std::min(from_border, period - from_border) < reach;
        };
        return bare.where([&](int x, int y) { return near_border(x) || near_border(y); }) / result.bare;
    };
    result.of_halves = seam(2);
    result.of_quarters = seam(4);
    result.of_eighths = seam(8);
    return result;
}

}  // namespace dapple
