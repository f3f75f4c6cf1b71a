#include "core/tile/ranking.h"

#include <algorithm>
#include <cmath>

#include "core/tile/candidates.h"

namespace dapple {

namespace {

// Cost: minus the squared distance to the nearest point so far.
std::vector<int> farthest_order(const std::vector<glm::dvec2>& placed, std::vector<glm::dvec2> positions,
                                const std::vector<Neighbour>& neighbours) {
    constexpr double kFarther = 9;  // than any two points of touching tiles, squared
    Candidates candidates(std::move(positions), -kFarther);
    std::vector<int> rank(candidates.size());
    const auto add = [&](glm::dvec2 p, double radius) {
        for_copies(p, neighbours, radius, [&](glm::dvec2 copy, double) {
            candidates.for_each_near(copy, radius, [&](std::uint32_t i, double squared) {
                if (-squared > candidates.cost(i)) candidates.set_cost(i, -squared);
            });
        });
    };
    // The placed points fill the tile: no candidate is farther from all of them than a few of their spacings.
    const double reach = placed.empty() ? 0 : 4 / std::sqrt(static_cast<double>(placed.size()));
    for (const glm::dvec2 p : placed) add(p, reach);
    for (std::size_t k = 0; k < rank.size(); ++k) {
        const std::uint32_t next = candidates.cheapest();
        rank[next] = static_cast<int>(k);
        // Nobody is farther from the points so far than the one chosen now.
        const double radius = std::sqrt(-candidates.cost(next)) * (1 + 1e-9);
        candidates.remove(next);
        add(candidates.position(next), radius);
    }
    return rank;
}

// Void and cluster (Ulichney 1993) on a given set of candidates: the Gaussian narrows as the points get
// denser.
// Candidates of a lower stage come first, if stages are given.
std::vector<int> energy_order(std::vector<glm::dvec2> placed, std::vector<glm::dvec2> positions,
                              const std::vector<Neighbour>& neighbours, std::span<const int> stage = {}) {
    // A small tile's copies are alike, and a wide Gaussian keeps their rows even; a large one does better
    // with closer looks, and is spared some of the work.
    constexpr double kStageCost = 1e4;  // far above any energy
    const bool small = placed.size() + positions.size() < 500;
    const double width = small ? 0.62 : 0.5;   // of the mean spacing at the count
    const double growth = small ? 1.0 : 1.05;  // of the count between two narrowings
    const double reach_in_widths = small ? 7 : 4.3;
    Candidates candidates(std::move(positions), 0);
    std::vector<int> rank(candidates.size());

    double falloff = 0, reach = 0, narrowed_at = 0;
    const auto spread = [&](glm::dvec2 p, auto add) {
        for_copies(p, neighbours, reach, [&](glm::dvec2 copy, double probability) {
            candidates.for_each_near(copy, reach, [&](std::uint32_t i, double squared) {
                add(i, probability * std::exp(-falloff * squared));
            });
        });
    };
    for (std::size_t k = 0; k < rank.size(); ++k) {
        const auto count = static_cast<double>(placed.size() + 1);
        if (count >= growth * narrowed_at) {
            narrowed_at = count;
            falloff = count / (2 * width * width);
            reach = reach_in_widths * width / std::sqrt(count);
            std::vector<double> costs(candidates.size(), 0.0);
            for (std::size_t i = 0; i < stage.size(); ++i) costs[i] = kStageCost * stage[i];
            for (const glm::dvec2 p : placed)
                spread(p, [&](std::uint32_t i, double energy) { costs[i] += energy; });
            candidates.set_costs(std::move(costs));
        }
        const std::uint32_t next = candidates.cheapest();
        rank[next] = static_cast<int>(k);
        candidates.remove(next);
        placed.push_back(candidates.position(next));
        spread(placed.back(),
               [&](std::uint32_t i, double energy) { candidates.set_cost(i, candidates.cost(i) + energy); });
    }
    return rank;
}

std::vector<glm::dvec2> positions_of(const Tile& tile) {
    std::vector<glm::dvec2> positions;
    for (const BinaryPoint p : tile.points) positions.push_back(to_unit_square(p));
    return positions;
}

std::vector<float> half_way(const std::vector<int>& ranks, float first) {
    std::vector<float> result;
    for (const int rank : ranks) result.push_back(first + static_cast<float>(rank) + 0.5f);
    return result;
}

}  // namespace

std::vector<int> farthest_point_ranks(const Tile& tile) {
    return farthest_order({}, positions_of(tile), legal_neighbours(tile.rule));
}

std::vector<float> rank_newborns_in_stages(const Tile& tile, std::span<const int> stage) {
    std::vector<glm::dvec2> born;
    for (const Newborn& n : newborns_of(tile)) born.push_back(to_unit_square(n.position));
    return half_way(energy_order(positions_of(tile), std::move(born), legal_neighbours(tile.rule), stage),
                    static_cast<float>(tile.size()));
}

std::vector<float> paper_newborn_ranks(const Tile& tile, std::span<const float> tile_ranks) {
    std::vector<float> ranks;
    for (const Newborn& n : newborns_of(tile))
        ranks.push_back(static_cast<float>(tile.size()) + 3 * tile_ranks[n.point]);
    return ranks;
}

Ranking rank(const Tile& tile, RankingMethod method) {
    const auto neighbours = legal_neighbours(tile.rule);
    const auto own = positions_of(tile);
    const auto newborns = newborns_of(tile);
    std::vector<glm::dvec2> born;
    for (const Newborn& n : newborns) born.push_back(to_unit_square(n.position));
    const float count = static_cast<float>(tile.size());

    if (method == RankingMethod::energy) {
        return {half_way(energy_order({}, own, neighbours), 0),
                half_way(energy_order(own, born, neighbours), count)};
    }
    const std::vector<int> ranks = farthest_order({}, own, neighbours);
    Ranking ranking{half_way(ranks, 0), {}};
    if (method == RankingMethod::farthest) {
        ranking.newborn = half_way(farthest_order(own, born, neighbours), count);
    } else {
        ranking.newborn = paper_newborn_ranks(tile, ranking.tile);
    }
    return ranking;
}

}  // namespace dapple
