#include "core/screening/threshold_mask.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/failure.h"

namespace dapple {

ThresholdMask tile_mask(RankedTile& tile, int side) {
    constexpr int kMostSide = 2048;
    if (side < 4 || side > kMostSide)
        throw failure("{} pixels: the side of a mask from a tile is 4 to {}", side, kMostSide);
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

namespace {

// Along a pixel's side, where it is asked how much of the paper printed pixels cover together.
constexpr int kParts = 8;

std::vector<std::uint32_t> pixels_by_rank(const ThresholdMask& mask, int slice) {
    std::vector<std::uint32_t> pixels(mask.size.of_slice());
    const std::size_t first = pixels.size() * static_cast<std::size_t>(slice);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[mask.ranks[first + i]] = static_cast<std::uint32_t>(i);
    return pixels;
}

// What a printed pixel covers of a pixel so far away from it, as far as its ink reaches: one bit for each
// part.
using Parts = std::bitset<kParts * kParts>;
Parts covered_parts(int dx, int dy, double gain) {
    // The square, rounded at its corners by the gain.
    const auto beyond = [](double at) { return std::max({-at, at - 1, 0.0}); };
    Parts parts;
    for (int y = 0; y < kParts; ++y)
        for (int x = 0; x < kParts; ++x)
            parts[static_cast<std::size_t>(y * kParts + x)] =
                std::hypot(beyond(dx + (x + 0.5) / kParts), beyond(dy + (y + 0.5) / kParts)) <= gain;
    return parts;
}

}  // namespace

void check_threshold_size(const ThresholdSize& size) {
    const auto is_side = [](int side) { return side >= 4 && side <= kMostThresholdSide; };
    if (!is_side(size.width) || !is_side(size.height))
        throw failure("{} x {} pixels: a mask's sides are 4 to {}", size.width, size.height,
                      kMostThresholdSide);
    if (size.slices < 1 || size.slices > kMostThresholdSlices)
        throw failure("{} slices: a mask has 1 to {}", size.slices, kMostThresholdSlices);
    if (size.all() > kMostThresholdPixels)
        throw failure("{} x {} x {} pixels: a mask has at most {} in all", size.width, size.height,
                      size.slices, kMostThresholdPixels);
}

ThresholdMask mask_by_order(const ThresholdSize& size, const std::vector<std::uint32_t>& order) {
    ThresholdMask mask{size, std::vector<std::uint32_t>(size.all())};
    std::vector<std::uint32_t> pixels(size.of_slice());
    for (int slice = 0; slice < size.slices; ++slice) {
        const std::size_t first = pixels.size() * static_cast<std::size_t>(slice);
        std::iota(pixels.begin(), pixels.end(), 0u);
        std::ranges::sort(pixels, {}, [&](std::uint32_t pixel) { return order[first + pixel]; });
        for (std::size_t rank = 0; rank < pixels.size(); ++rank)
            mask.ranks[first + pixels[rank]] = static_cast<std::uint32_t>(rank);
    }
    return mask;
}

Grid<float> thresholds_of(const ThresholdMask& mask, int slice, double gain) {
    const auto [width, height, slices] = mask.size;
    const auto all = static_cast<double>(mask.size.of_slice());
    Grid<float> thresholds(width, height);
    const std::vector<std::uint32_t> pixels = pixels_by_rank(mask, slice);
    if (gain <= 0) {
        for (std::size_t rank = 0; rank < pixels.size(); ++rank)
            thresholds.values[pixels[rank]] = static_cast<float>((static_cast<double>(rank) + 0.5) / all);
        return thresholds;
    }
    struct Near {
        int dx, dy;
        Parts parts;
    };
    std::vector<Near> neighbours;
    const int reach = static_cast<int>(std::ceil(gain));
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (const Parts parts = covered_parts(dx, dy, gain); parts.any())
                neighbours.push_back({dx, dy, parts});
    Grid<Parts> covered(width, height);
    std::size_t parts = 0;
    for (const std::uint32_t pixel : pixels) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        const std::size_t before = parts;
        for (const Near& neighbour : neighbours) {
            const auto wrapped = [](int at, int side) { return ((at % side) + side) % side; };
            Parts& there = covered.at(wrapped(x + neighbour.dx, width), wrapped(y + neighbour.dy, height));
            parts += (neighbour.parts & ~there).count();
            there |= neighbour.parts;
        }
        thresholds.values[pixel] =
            static_cast<float>(static_cast<double>(before + parts) / 2 / (all * kParts * kParts));
    }
    return thresholds;
}

Grid<float> screened(const Grid<float>& light, const Grid<float>& thresholds) {
    Grid<float> pixels(light.width, light.height);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            const float ink = 1 - light.at(x, y);
            const bool inked = ink > thresholds.at(x % thresholds.width, y % thresholds.height);
            pixels.at(x, y) = inked ? 0.0f : 1.0f;
        }
    return pixels;
}

std::vector<glm::dvec2> inked_places(const ThresholdMask& mask, std::uint32_t count, int slice) {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < mask.size.height; ++y)
        for (int x = 0; x < mask.size.width; ++x)
            if (mask.rank(x, y, slice) < count) places.emplace_back(x + 0.5, y + 0.5);
    return places;
}

}  // namespace dapple
