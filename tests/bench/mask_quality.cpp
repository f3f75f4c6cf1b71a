// How even the pixels are that threshold masks ink, at greys from light to dark: masks of the program beside
// void and cluster done plainly, as its paper says it. Prints a table in Markdown, and how long they took.
//
//      mask_quality [SIDE]        128 without it

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "core/analysis/periodogram.h"
#include "core/drawing/settings.h"
#include "core/screening/threshold_mask.h"
#include "io/files/tile_library.h"

namespace {

using namespace dapple;

// Ulichney 1993, step by step: all pixels are looked at for each void and each cluster.
ThresholdMask plain_void_and_cluster(int side) {
    constexpr double kSigma = 1.5;
    const auto count = static_cast<std::size_t>(side) * side;
    std::vector<double> energy(count);
    std::vector<char> inked(count);
    const auto change = [&](std::size_t pixel, bool ink) {
        inked[pixel] = ink;
        const int x0 = static_cast<int>(pixel) % side, y0 = static_cast<int>(pixel) / side;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const int dx = std::min(std::abs(x - x0), side - std::abs(x - x0)),
                          dy = std::min(std::abs(y - y0), side - std::abs(y - y0));
                const double felt = std::exp(-(dx * dx + dy * dy) / (2 * kSigma * kSigma));
                energy[static_cast<std::size_t>(y) * side + x] += ink ? felt : -felt;
            }
    };
    const auto cluster = [&] {
        std::size_t best = count;
        for (std::size_t i = 0; i < count; ++i)
            if (inked[i] && (best == count || energy[i] > energy[best])) best = i;
        return best;
    };
    const auto void_place = [&] {
        std::size_t best = count;
        for (std::size_t i = 0; i < count; ++i)
            if (!inked[i] && (best == count || energy[i] < energy[best])) best = i;
        return best;
    };
    std::mt19937 random(1);
    std::vector<std::size_t> first;
    while (first.size() < count / 10)
        if (const std::size_t pixel = random() % count; !inked[pixel]) {
            change(pixel, true);
            first.push_back(pixel);
        }
    while (true) {
        const std::size_t from = cluster();
        change(from, false);
        const std::size_t to = void_place();
        change(to, true);
        if (to == from) break;
    }
    const auto begin = std::pair(energy, inked);
    ThresholdMask mask{{side, side, 1}, std::vector<std::uint32_t>(count)};
    for (std::size_t rank = count / 10; rank-- > 0;) {
        const std::size_t pixel = cluster();
        mask.ranks[pixel] = static_cast<std::uint32_t>(rank);
        change(pixel, false);
    }
    std::tie(energy, inked) = begin;
    for (std::size_t rank = count / 10; rank < count; ++rank) {
        const std::size_t pixel = void_place();
        mask.ranks[pixel] = static_cast<std::uint32_t>(rank);
        change(pixel, true);
    }
    return mask;
}

// The mean power of the fewer pixels, inked or bare, up to that many times the root of how many they are; 1
// is white noise.
double power_below(const ThresholdMask& mask, double grey, double frequency) {
    ThresholdMask fewer = mask;
    const auto all = static_cast<std::uint32_t>(mask.size.of_slice());
    if (grey > 0.5)
        for (std::uint32_t& rank : fewer.ranks) rank = all - 1 - rank;
    const double share = std::min(grey, 1 - grey);
    const auto places = inked_places(fewer, static_cast<std::uint32_t>(std::lround(share * all)));
    const Domain domain{double(mask.size.width), double(mask.size.height)};
    const Periodogram spectrum = periodogram(places, domain, {.highest_frequency = frequency});
    return low_frequency_power(spectrum, frequency) / (1 - share);
}

template <class Make>
std::pair<ThresholdMask, double> timed(const Make& make) {
    const auto begin = std::chrono::steady_clock::now();
    ThresholdMask mask = make();
    return {std::move(mask), std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc > 1 ? std::atoi(argv[1]) : 128;
    RankedTile tile = tile_named(kDefaultTile);
    const auto [clusters, seconds] = timed([&] { return void_and_cluster({side, side}); });
    const auto [plain, plain_seconds] = timed([&] { return plain_void_and_cluster(side); });
    const auto [by_tile, tile_seconds] = timed([&] { return tile_mask(tile, side); });
    const ThresholdMask film = void_and_cluster({side, side, 16});
    fmt::print("| ink | void and cluster | the same, plainly | a slice of 16 | from the tile |\n");
    fmt::print("|---|---|---|---|---|\n");
    for (const double grey :
         {1 / 32.0, 1 / 16.0, 1 / 8.0, 1 / 4.0, 3 / 8.0, 1 / 2.0, 5 / 8.0, 3 / 4.0, 7 / 8.0, 15 / 16.0}) {
        fmt::print("| {:.1f} % |", 100 * grey);
        for (const ThresholdMask* mask : {&clusters, &plain, &film, &by_tile})
            fmt::print(" {:.3f} / {:.3f} |", power_below(*mask, grey, 0.3), power_below(*mask, grey, 0.5));
        fmt::print("\n");
    }
    fmt::print("| seconds | {:.2f} | {:.2f} | | {:.2f} |\n", seconds, plain_seconds, tile_seconds);
}
