#pragma once
// All criteria of a ranked tile in one value, and in words.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

/// Each number is explained where its function is declared, in criteria.h.
struct TileMarks {
    std::array<int, 4> letters{};  // points in each quadrant
    bool balanced = false;
    double relative_radius = 0;
    double worst_relative_radius = 0;
    double coherent_share = 0;
    double low_frequency_power = 0;
    double lattice_share = 0;
    std::size_t kinds = 1;
    std::vector<double> coincidences;  // of orientations at the lags 1, 2, ... 64; of several kinds those of
                                       // kinds, up to 32
    double orientation_coincidence = 0;  // at the lag where it is highest, or that of kinds
    int coincidence_lag = 1;
};

TileMarks marks_of(const Tile& tile, const Ranking& ranking);

/// A number with its name and a verdict: "relative radius", "0.653", "half the smallest distance ...".
struct TileMark {
    std::string name, value, meaning;
};
std::vector<TileMark> in_words(const TileMarks& marks);

}  // namespace dapple
