#include "lab/reproduce/figure8_dots.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>

#include "core/text/shown_text.h"
#include "core/tile/ranking.h"

namespace dapple {

Figure8Drawing figure8_drawing(const Density& density, std::size_t emitted) {
    constexpr double kMostScale = 1e12;
    constexpr int kMostRounds = 60;
    const Tile tile = make_tile(14217, 2895, 16);
    const std::vector<int> ranks = farthest_point_ranks(tile);
    const auto place = [&](double scale) {
        const auto start = std::chrono::steady_clock::now();
        Figure8Drawing drawing{place_figure8(density, tile, ranks, scale)};
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        drawing.place_ms = time.count();
        return drawing;
    };
    // The number grows with the scale: between a scale with too few and one with enough.
    double low = 0, high = 1, too_few = 0;
    Figure8Drawing enough = place(high);
    while (enough.placed.dots.size() < emitted) {
        low = high;
        too_few = static_cast<double>(enough.placed.dots.size());
        high *= 2;
        if (high > kMostScale)
            throw std::runtime_error(
                fmt::format("Figure 8 does not find {} places in this picture", emitted));
        enough = place(high);
    }
    for (int round = 0; round < kMostRounds && enough.placed.dots.size() > emitted; ++round) {
        // Nearly a straight line; every third time the middle, against a bend.
        const double have = static_cast<double>(enough.placed.dots.size());
        const double share =
            round % 3 == 2
                ? 0.5
                : std::clamp((static_cast<double>(emitted) - too_few) / (have - too_few), 0.02, 0.98);
        const double middle = low + share * (high - low);
        if (middle <= low || middle >= high) break;
        Figure8Drawing drawing = place(middle);
        if (drawing.placed.dots.size() >= emitted) {
            high = middle;
            enough = std::move(drawing);
        } else {
            low = middle;
            too_few = static_cast<double>(drawing.placed.dots.size());
        }
    }
    return enough;
}

std::string in_words(const Figure8Drawing& drawing) {
    return fmt::format("{} dots, {} of them a second time, placed in {:.1f} ms",
                       grouped(drawing.placed.dots.size()), grouped(drawing.placed.duplicates),
                       drawing.place_ms);
}

}  // namespace dapple
