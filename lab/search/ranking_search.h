#pragma once
// A search for the order in which a tile's newborn points appear: better than greedy choice, and slower.
//
// A greedy order chooses well at first and takes what is left at the end. Here the way from one level to the
// next is cut into stages, at each of which the points so far should be even: n_s = N 4^(s / stages), s = 1
// .. stages. The sum over stages of the energy of pairs (PairShape, in spacings at n_s) is lowered by
// simulated annealing, two newborn points exchanging their stages. A pair counts from the stage at which its
// later point is there, so its part of the sum is one number from a table. Within a stage the order is
// void-and-cluster's.

#include <cstdint>
#include <stop_token>

#include "core/tile/ranking.h"
#include "lab/search/pair_energy.h"

namespace dapple {

struct RankingSearchSettings {
    int stages = 12;                  // 2..100; of several kinds there are kRankStages
    std::uint64_t exchanges = 0;      // tried; 0: a thousand a newborn point
    std::uint64_t seed = 1;           // same settings, same ranking
    double start_temperature = 0.05;  // in the unit of the energy of one pair
    double end_temperature = 0.001;   // reached geometrically
    PairShape shape{0.7, 2, 0.7};     // wider and softer than a tile's: the choice is smaller
    std::stop_token stop;             // the order so far is returned
};

/// Starts from the energy order, which the tile's own points keep. About 300,000 exchanges a second.
Ranking search_ranking(const Tile& tile, const RankingSearchSettings& settings = {});

/// The sum that the search lowers, per newborn point, for any ranking.
double ranking_energy(const Tile& tile, const Ranking& ranking, const RankingSearchSettings& settings = {});

}  // namespace dapple
