#pragma once
// A search for tiles of several kinds: copies of one good tile, annealed apart.
//
// All kinds have the identity orientation and start as the same tile, whose copies fit each other, and each
// kind has to fit itself and all others to the end. Re-linking (relink_search.h) then changes each by itself;
// here a point's successor is one of another kind. The energy is that of KindLinks.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/tile/tile.h"
#include "lab/search/pair_energy.h"

namespace dapple {

/// A substitution in which each kind is the child of as many kinds in each quadrant, one, and which repeats
/// little: the best of many random ones by kind_coincidence() and page_coincidence(). Throws
/// std::runtime_error for fewer than 2 kinds or more than kMaxKinds.
NextKinds mixed_kinds(int kinds, std::uint64_t seed);

struct KindSearchProgress {
    std::uint64_t moves = 0;  // tried so far
    double energy = 0;        // per point
    double acceptance = 0;    // share of the moves taken since the last report
};

/// What one of several searches for the same tile has, which go on side by side.
struct Island {
    double energy = 0;         // per point
    std::string letters = {};  // of all points, kind after kind: their quadrants, '0' to '3'
    std::vector<std::uint32_t> successors = {};  // of the same points
    bool stops = false;                          // the search is to end here
};

Island island_of(const Tile& tile, double energy);

/// The one of lowest energy among all islands, the first of several; it stops if any does. Returns when all
/// have called it.
using BestIsland = std::function<Island(const Island&)>;

struct KindSearchSettings {
    Tile start;                       // of one kind and the identity rule
    int kinds = 16;                   // 2..kMaxKinds
    std::uint64_t seed = 1;           // same settings, same tile
    std::uint64_t moves = 0;          // tried, unless there is a clock
    std::function<double()> clock;    // seconds since some beginning
    double seconds = 0;               // by the clock, the length of the search
    double start_temperature = 0.25;  // in the unit of the energy
    double end_temperature = 0.02;    // reached geometrically
    double move_radius = 1.5;         // in spacings, how far a successor jumps, at most 4 tone_width
    double apart = 0.15;              // how much it counts that kinds differ; see KindLinks
    PairShape shape;
    // An island among others tries moves of its own, and goes on from the best of them kExchanges times, at
    // equal distances, of which the last is the end.
    int island = 0;
    BestIsland best = {};
    std::function<void(const KindSearchProgress&)> progress;  // every few moves a point
    std::stop_token stop;                                     // what there is is returned
};

inline constexpr int kExchanges = 16;

struct KindSearchResult {
    Tile tile;
    double energy = 0;        // per point
    std::uint64_t moves = 0;  // tried
};

/// Some million moves a second. Throws std::runtime_error if the start is of several kinds or turned, or
/// there are too many or too few kinds.
KindSearchResult kind_search(const KindSearchSettings& settings);

}  // namespace dapple
