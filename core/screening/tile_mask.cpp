#include "core/screening/tile_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace dapple {

ThresholdMask tile_mask(RankedTile& tile, int side) {
    constexpr int kMostSide = 2048;
    if (side < 4 || side > kMostSide)
        throw std::runtime_error(
            fmt::format("{} pixels: the side of a mask from a tile is 4 to {}", side, kMostSide));
    const ThresholdSize size{side, side, 1};
    const Density grey(Grid<float>(1, 1, 1.0f));
    std::vector<float> critical(size.all());  // of each pixel's first dot
    // About so many dots for each pixel: most have one among the first few.
    for (double dots = 8;; dots *= 4) {
        std::ranges::fill(critical, std::numeric_limits<float>::infinity());
        Stippling drawn;
        stipple(tile, grey, PlacerKind::exact,
                {.scale = dots * static_cast<double>(size.all()) / kDotsPerScale,
                 .threads = 0,
                 .thresholds = true},
                drawn);
        for (const Dots& piece : drawn.dots.pieces)
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const auto at = [&](float place) {
                    return std::clamp(static_cast<int>(place * static_cast<float>(side)), 0, side - 1);
                };
                float& first = critical[static_cast<std::size_t>(at(piece.y[i])) * side + at(piece.x[i])];
                first = std::min(first, piece.critical[i]);
            }
        if (std::ranges::find(critical, std::numeric_limits<float>::infinity()) == critical.end()) break;
    }
    std::vector<std::uint32_t> pixels(size.all()), order(size.all());
    std::iota(pixels.begin(), pixels.end(), 0u);
    std::ranges::stable_sort(pixels, {}, [&](std::uint32_t pixel) { return critical[pixel]; });
    for (std::size_t rank = 0; rank < pixels.size(); ++rank)
        order[pixels[rank]] = static_cast<std::uint32_t>(rank);
    return mask_by_order(size, order);
}

}  // namespace dapple
