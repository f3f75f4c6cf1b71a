// Threshold masks: their order against its definition, their greys as they print.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/analysis/distances.h"
#include "core/drawing/settings.h"
#include "core/screening/threshold_mask.h"
#include "io/files/tile_library.h"

namespace dapple {
namespace {

bool is_permutation_of_all(const ThresholdMask& mask, int slice) {
    std::set<std::uint32_t> ranks;
    for (int y = 0; y < mask.size.height; ++y)
        for (int x = 0; x < mask.size.width; ++x) ranks.insert(mask.rank(x, y, slice));
    return ranks.size() == mask.size.of_slice() && *ranks.rbegin() + 1 == ranks.size();
}

/// What a pixel feels of another on the torus, by the formula, with images as far as they count.
double felt(const ThresholdSize& size, std::size_t a, std::size_t b, double sigma) {
    const auto dx = static_cast<double>(a % size.width) - static_cast<double>(b % size.width);
    const auto dy = static_cast<double>(a / size.width) - static_cast<double>(b / size.width);
    double sum = 0;
    for (int j = -6; j <= 6; ++j)
        for (int i = -6; i <= 6; ++i)
            sum += std::exp(-(std::pow(dx + i * size.width, 2) + std::pow(dy + j * size.height, 2)) /
                            (2 * sigma * sigma));
    return sum;
}

}  // namespace

TEST_CASE("each pixel is inked where there is least of those before it, as void and cluster says") {
    struct Case {
        ThresholdSize size;
        double sigma;
    };
    for (const Case& each : {Case{{24, 24}, 1.5}, {{5, 37}, 1.5}, {{16, 20}, 2.5}}) {
        const ThresholdSize size = each.size;
        const double sigma = each.sigma;
        CAPTURE(size.width);
        const ThresholdMask mask = void_and_cluster(size, {.sigma = sigma, .seed = 7});
        REQUIRE(is_permutation_of_all(mask, 0));
        std::vector<std::size_t> pixels(size.all());
        for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) pixels[mask.ranks[pixel]] = pixel;
        std::vector<double> energy(size.all());  // of the pixels inked so far
        const std::size_t first = size.all() / 10;
        double worst = 0;
        for (std::size_t rank = 0; rank < size.all(); ++rank) {
            // The first ones were taken away from their tightest clusters, the last first: each is the
            // tightest of those up to it. The others were added.
            if (rank >= first) {
                double least = 1e9;
                for (std::size_t later = rank; later < size.all(); ++later)
                    least = std::min(least, energy[pixels[later]]);
                worst = std::max(worst, energy[pixels[rank]] - least);
            }
            for (std::size_t pixel = 0; pixel < size.all(); ++pixel)
                energy[pixel] += felt(size, pixel, pixels[rank], sigma);
            if (rank < first) {
                double most = 0;
                for (std::size_t before = 0; before <= rank; ++before)
                    most = std::max(most, energy[pixels[before]]);
                worst = std::max(worst, most - energy[pixels[rank]]);
            }
        }
        CHECK(worst < 2e-3);  // the noise that keeps them from being equal, and rounding
    }
}

TEST_CASE("a mask is the same each time, and another with another seed") {
    const ThresholdSize size{32, 32};
    const auto ranks = void_and_cluster(size).ranks;
    CHECK(void_and_cluster(size).ranks == ranks);
    CHECK(void_and_cluster(size, {.seed = 2}).ranks != ranks);
}

TEST_CASE("the pixels of every grey are far more even than white noise, across the edges too") {
    const ThresholdSize size{64, 64};
    RankedTile tile = tile_named(kDefaultTile);
    for (const ThresholdMask& mask : {void_and_cluster(size), tile_mask(tile, 64)}) {
        REQUIRE(is_permutation_of_all(mask, 0));
        for (const double grey : {0.03, 0.1, 0.2}) {
            CAPTURE(grey);
            const auto places = inked_places(mask, static_cast<std::uint32_t>(grey * 4096));
            CHECK(nearest_summary(places, {64, 64}).mean > 0.66);  // white noise: .47
        }
    }
}

TEST_CASE("a tile's mask inks the pixels into which the first dots of its subdivision fall") {
    RankedTile tile = tile_named("paper16");
    const ThresholdMask mask = tile_mask(tile, 32);
    const Density grey(Grid<float>(1, 1, 1.0f));
    for (const std::uint64_t dots : {1u, 5u, 60u, 200u}) {
        CAPTURE(dots);
        Stippling drawn;
        REQUIRE(stipple(tile, grey, PlacerKind::exact, {.count = dots}, drawn));
        std::set<std::pair<int, int>> pixels;
        for (const Dots& piece : drawn.dots.pieces)
            for (std::size_t i = 0; i < piece.size(); ++i)
                pixels.emplace(static_cast<int>(piece.x[i] * 32), static_cast<int>(piece.y[i] * 32));
        std::uint32_t highest = 0;
        for (const auto& [x, y] : pixels) highest = std::max(highest, mask.rank(x, y));
        CHECK(highest + 1 == pixels.size());
    }
}

TEST_CASE("of a mask for films each slice is even, and each pixel is inked in turn") {
    const ThresholdSize size{32, 32, 16};
    const ThresholdMask mask = void_and_cluster(size);
    const std::uint32_t quarter = 32 * 32 / 4;
    double inked_again = 0;
    for (int slice = 0; slice < size.slices; ++slice) {
        CAPTURE(slice);
        REQUIRE(is_permutation_of_all(mask, slice));
        CHECK(nearest_summary(inked_places(mask, quarter / 4, slice), {32, 32}).mean > 0.66);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                inked_again +=
                    mask.rank(x, y, slice) < quarter && mask.rank(x, y, (slice + 1) % size.slices) < quarter;
    }
    // Of pixels inked in a quarter of all slices: by chance a quarter of those would be inked in the next.
    CHECK(inked_again / (quarter * size.slices) < 0.05);
}

TEST_CASE("with a dot gain greys print as dark as they are, and without one a pixel covers itself") {
    const ThresholdMask mask = void_and_cluster({32, 32});
    const Grid<float> plain = thresholds_of(mask);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) CHECK(plain.at(x, y) == doctest::Approx((mask.rank(x, y) + 0.5) / 1024));
    for (const double gain : {0.3, 1.2}) {
        const Grid<float> thresholds = thresholds_of(mask, 0, gain);
        for (const float grey : {0.05f, 0.3f, 0.6f, 0.9f}) {
            CAPTURE(gain);
            CAPTURE(grey);
            const Grid<float> pixels = screened(Grid<float>(32, 32, 1 - grey), thresholds);
            // Printed: the paper within the gain of an inked square, looked at in points.
            constexpr int kPoints = 7;
            double covered = 0;
            for (int v = 0; v < 32 * kPoints; ++v)
                for (int u = 0; u < 32 * kPoints; ++u) {
                    const double x = (u + 0.5) / kPoints, y = (v + 0.5) / kPoints;
                    bool ink = false;
                    for (int dy = -2; dy <= 2; ++dy)
                        for (int dx = -2; dx <= 2; ++dx) {
                            const double left = std::floor(x) + dx, top = std::floor(y) + dy;
                            const bool inked = pixels.at((static_cast<int>(left) + 32) % 32,
                                                         (static_cast<int>(top) + 32) % 32) == 0;
                            ink |= inked && std::hypot(std::max({left - x, x - left - 1, 0.0}),
                                                       std::max({top - y, y - top - 1, 0.0})) <= gain;
                        }
                    covered += ink;
                }
            CHECK(covered / (32.0 * 32 * kPoints * kPoints) == doctest::Approx(grey).epsilon(0.03));
        }
    }
}

TEST_CASE("a screened picture has as much ink as it is dark, and none on white") {
    const Grid<float> thresholds = thresholds_of(void_and_cluster({16, 16}));
    const auto inked = [&](float light) {
        const Grid<float> pixels = screened(Grid<float>(48, 32, light), thresholds);
        return static_cast<double>(std::ranges::count(pixels.values, 0.0f)) / (48 * 32);
    };
    CHECK(inked(1) == 0);
    CHECK(inked(2) == 0);  // brighter than paper
    CHECK(inked(0) == 1);
    CHECK(inked(0.75) == doctest::Approx(0.25));
    CHECK(inked(0.5) == doctest::Approx(0.5));
}

TEST_CASE("what cannot be a mask is refused in a sentence") {
    CHECK_THROWS_WITH(void_and_cluster({3, 64}), "3 x 64 pixels: a mask's sides are 4 to 8192");
    CHECK_THROWS_WITH(void_and_cluster({64, 64, 0}), "0 slices: a mask has 1 to 1024");
    CHECK_THROWS_WITH(void_and_cluster({8192, 8192, 2}),
                      "8192 x 8192 x 2 pixels: a mask has at most 67108864 in all");
    CHECK_THROWS_WITH(void_and_cluster({64, 64}, {.sigma = 9}), "sigma 9: it is 0.5 to 4 pixels");
    RankedTile tile = tile_named("paper16");
    CHECK_THROWS_WITH(tile_mask(tile, 3), "3 pixels: the side of a mask from a tile is 4 to 2048");
}

TEST_CASE("a mask can be given up") {
    int told = 0;
    const ThresholdMask mask = void_and_cluster({256, 256}, {}, [&](double share) {
        CHECK(share < 1);
        return ++told < 2;
    });
    CHECK(told == 2);
    CHECK(mask.ranks.empty());
}

}  // namespace dapple
