#pragma once
// The best of all balanced tiles of several small cycles: the paper's variation of putting four tiles of 4
// points together into one of 16 (Lagae & Dutré 2006, section 7). Identity rule.
//
//      search_cycles({4, 4, 4, 4}, 5).best[0].words;  // "0013", "0211", "0233", "1322"
//
// There are few cycles of few points, 60 of 4 and 670 of 6, so that the distances between any two of them are
// a table; sets are put together a cycle at a time, and given up when two cycles are too close, or a quadrant
// too full. The search goes in passes with lower and lower floors, as the one for single words does.

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

namespace dapple {

/// Longer cycles are too many for the table.
inline constexpr int kMostCycleLength = 6;

struct FoundCycles {
    /// Each the smallest of its rotations, in ascending order; of the tile's eight images the smallest.
    std::vector<std::string> words;
    double relative_radius = 0;
    bool operator==(const FoundCycles&) const = default;
};

struct CycleSearchResult {
    std::vector<FoundCycles> best;  // best first, equal radii by words; distinct up to symmetry
    bool finished = false;          // none is left out
};

/// The `top` best tiles, each of cycles of these lengths and with a quarter of its points in each quadrant.
/// No two points coincide. Throws std::runtime_error unless the lengths are from 1 to kMostCycleLength and
/// together a multiple of 4.
CycleSearchResult search_cycles(std::vector<int> lengths, std::size_t top, const std::stop_token& stop = {});

}  // namespace dapple
