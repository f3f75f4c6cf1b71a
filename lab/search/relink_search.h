#pragma once
// A search for large tiles whose pictures do not repeat: annealing by re-linking.
//
// In a tile every point a of quadrant q is the half-size image of its successor: a = S_q(h_q(successor of
// a)). Giving it another successor that lies near the old one, at a distance d, moves it by d / 2, its
// predecessors by d / 4, theirs by d / 8 and so on: a small change of the picture, though the words change
// beyond recognition, cycles and tails growing and breaking as they like. Each point keeps its quadrant; the
// new successor must not have a predecessor there yet, or the two would coincide.
//
//      ... -> c -> a -> from               ... -> c -> a    from
//                                                       `--.
//                       to                                `-> to
//
// The energy of EnergyGrid, over all legal neighbours, is lowered by simulated annealing over that move.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/tile/tile.h"
#include "lab/search/pair_energy.h"

namespace dapple {

/// Four orientations with which no direction of the plane is preferred and equal orientations are rare at
/// every distance; see orientation_coincidence().
Rule aperiodic_rule();

struct RelinkProgress {
    Rule rule;                       // of this run
    std::uint64_t seed = 0;          // of this run
    std::uint64_t moves = 0;         // tried so far
    std::uint64_t new_moves = 0;     // of these since the last report
    double energy = 0, best = 0;     // per point, each pair counted once, penalty included
    double acceptance = 0;           // share of the moves taken since the last report
    double highest_peak = 0;         // of the coherent powers, if they are part of the search
    std::vector<std::string> words;  // the best tile so far
};

struct RelinkSettings {
    Rule rule = aperiodic_rule();
    std::size_t points = 1024;         // a multiple of 4 up to kMaxTilePoints
    std::vector<std::string> start;    // words to start from; empty: see even_words()
    std::uint64_t seed = 1;            // same settings, same tile
    std::uint64_t moves = 10'000'000;  // tried, unless there is a clock
    std::function<double()> clock;     // seconds since some beginning; called by all threads
    double seconds = 0;                // by the clock, the length of the search: as many moves as it allows
    double start_temperature = 0.1;    // in the unit of the energy
    double end_temperature = 0.03;     // reached geometrically
    double move_radius = 1.5;          // in spacings, how far a successor jumps, at most 4 tone_width
    PairShape shape;
    double peak_weight = 0.005;                           // of CoherentPeaks; 0: none
    double peak_limit = 12;                               // of CoherentPeaks
    std::function<void(const RelinkProgress&)> progress;  // every few hundred moves a point, and at the end
    std::stop_token stop;                                 // the best so far is returned
};

struct RelinkResult {
    Tile tile;
    double energy = 0;        // per point, each pair counted once, penalty included
    std::uint64_t moves = 0;  // tried
};

/// Cools as moves are used up, or as time is: then the tile depends on how fast the machine is, and another
/// search finds another one. At least some moves are tried.
/// Throws std::runtime_error if `points` or `start` cannot be a tile.
RelinkResult relink_search(const RelinkSettings& settings);

/// Independent runs on all cores, lowest energy first. Those with a clock take turns if there are more than
/// cores, and have a part of their seconds each, so that all together last as long as one.
std::vector<RelinkResult> relink_searches(std::vector<RelinkSettings> runs);

/// The same with the seeds seed, seed + 1, ...
std::vector<RelinkResult> relink_searches(const RelinkSettings& settings, int runs);

/// The energy of a tile, per point, summed afresh.
double relink_energy(const Tile& tile, const PairShape& shape);

/// Cyclic words with which every square of level k holds equally many of the points, 4^k being the largest
/// power of 4 that divides their number: each k-letter window occurs equally often. Random circuits of de
/// Bruijn's graph.
std::vector<std::string> even_words(std::size_t points, std::uint64_t seed);

}  // namespace dapple
