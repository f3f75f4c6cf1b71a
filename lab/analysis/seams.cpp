#include "lab/analysis/seams.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/output/raster.h"
#include "core/text/number_words.h"

namespace dapple {

Grid<float> raster_of_dots(std::span<const glm::dvec2> dots, double radius, const PixelPage& page) {
    Dots columns;
    columns.reserve(dots.size(), false);
    for (const glm::dvec2 dot : dots) {
        columns.x.push_back(float(dot.x));
        columns.y.push_back(float(dot.y));
    }
    // A millimetre is a pixel.
    const PageSize size{double(page.width), double(page.height), page.pixels_per_unit};
    return coverage_of(
        {.size = size, .dots = stream_of(columns), .dot_radius_mm = radius * page.pixels_per_unit},
        {.dpi = kMmPerInch, .threads = 0});
}

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

namespace {

constexpr std::size_t kFewestDotsForSeams = 40'000;

}  // namespace

std::size_t full_level(const RankedTile& tile, std::size_t fewest_dots) {
    std::size_t level = tile.tile().size();
    while (level < fewest_dots) level *= 4;
    return level;
}

Seams seams_on_black(RankedTile& tile) {
    const Density black(Grid<float>(1, 1, 1.0f));
    PlacingRequest request;
    request.scale = static_cast<double>(full_level(tile, kFewestDotsForSeams)) / kDotsPerScale;
    Stippling placed;
    stipple(tile, black, PlacerKind::exact, request, placed);
    std::vector<glm::dvec2> dots;
    for_each_position(placed.dots, [&](float x, float y) { dots.emplace_back(x, y); });
    return seams(dots, kSeamLoad);
}

}  // namespace dapple
