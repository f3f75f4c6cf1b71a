#include "lab/search/tile_marks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "lab/search/criteria.h"

namespace dapple {
namespace {

constexpr int kLags = 64;

// The first of three words if the value is at most `good`, the second if at most `fair`.
std::string_view verdict(double value, double good, double fair, std::array<std::string_view, 3> words) {
    return value <= good ? words[0] : value <= fair ? words[1] : words[2];
}

}  // namespace

TileMarks marks_of(const Tile& tile, const Ranking& ranking) {
    TileMarks marks;
    marks.letters = letter_counts(tile);
    marks.balanced = std::ranges::all_of(marks.letters, [&](int n) { return n == marks.letters[0]; });
    marks.relative_radius = relative_radius(tile);
    marks.worst_relative_radius = worst_relative_radius(tile, ranking);
    marks.coherent_share = coherent_share(tile);
    marks.low_frequency_power = low_frequency_power(tile);
    marks.lattice_share = lattice_share(tile);
    marks.kinds = tile.kinds();
    marks.coincidences =
        tile.kinds() > 1 ? kind_coincidence(tile.next_kind) : orientation_coincidence(tile.rule, kLags);
    const auto highest = std::ranges::max_element(marks.coincidences);
    marks.orientation_coincidence = *highest;
    marks.coincidence_lag = static_cast<int>(highest - marks.coincidences.begin()) + 1;
    return marks;
}

std::vector<TileMark> in_words(const TileMarks& marks) {
    const TileMark coincidence =
        marks.kinds > 1
            ? TileMark{"kind coincidence", fmt::format("{:.4f}", marks.orientation_coincidence),
                       fmt::format("of tiles {} apart of one kind, the highest up to {}; chance is {:.4f}",
                                   marks.coincidence_lag, marks.coincidences.size(),
                                   1 / static_cast<double>(marks.kinds))}
            : TileMark{"orientation coincidence", fmt::format("{:.4f}", marks.orientation_coincidence),
                       fmt::format("of tiles {} apart turned alike, the highest up to {}; chance is 0.125",
                                   marks.coincidence_lag, kLags)};
    return {
        {"balanced", marks.balanced ? "yes" : "no",
         fmt::format("points in the quadrants: {}", fmt::join(marks.letters, ", "))},
        {"relative radius", fmt::format("{:.6f}", marks.relative_radius),
         "half the smallest distance over the densest packing's"},
        {"worst relative radius", fmt::format("{:.6f}", marks.worst_relative_radius),
         "the same between two levels, where it is lowest"},
        {"coherent share", fmt::format("{:.4f}", marks.coherent_share),
         fmt::format("of the spectrum that repeats with the tile: {}",
                     verdict(marks.coherent_share, 0.2, 0.5, {"hardly", "partly", "mostly"}))},
        {"low-frequency power", fmt::format("{:.4f}", marks.low_frequency_power),
         fmt::format("unevenness of tone, white noise has 1: {}",
                     verdict(marks.low_frequency_power, 0.07, 0.15, {"even", "fair", "blotchy"}))},
        {"lattice share", fmt::format("{:.4f}", marks.lattice_share),
         fmt::format(
             "of points that one shift takes to others: {}",
             verdict(marks.lattice_share, 0.4, 0.7, {"irregular", "rows may show", "nearly a lattice"}))},
        coincidence,
    };
}

}  // namespace dapple
