#include "core/tile/ranking.h"

#include <algorithm>
#include <cmath>

#include "core/tile/candidates.h"

namespace dapple {

namespace {

// Squared distances of candidates to the nearest point so far. What lies beside a tile is the tile in one of
// several orientations: over these, as often as they occur, the mean is taken. The nearest of all of them at
// once is nearer than any drawing has it, and a tile's border would stay empty to the end.
class Distances {
 public:
    static constexpr double kFarther = 9;  // than any two points of touching tiles, squared

    Distances(std::size_t candidates, const std::vector<Neighbour>& neighbours)
        : neighbours_(neighbours),
          columns_(neighbours.size() + 1),
          nearest_(candidates * columns_, kFarther) {}

    /// Of a candidate, to a point of its own tile. True if none was nearer.
    bool add_own(std::uint32_t i, double squared) { return add(i, neighbours_.size(), squared); }
    /// To a point of one of the neighbours.
    bool add(std::uint32_t i, std::size_t neighbour, double squared) {
        double& nearest = nearest_[i * columns_ + neighbour];
        if (squared >= nearest) return false;
        nearest = squared;
        return true;
    }

    double own(std::uint32_t i) const { return nearest_[i * columns_ + neighbours_.size()]; }

    double mean(std::uint32_t i) const {
        const double* const nearest = &nearest_[i * columns_];
        double smallest = own(i);
        for (std::size_t n = 0; n < neighbours_.size();) {
            const glm::ivec2 place = neighbours_[n].offset;
            double mean = 0;
            for (; n < neighbours_.size() && neighbours_[n].offset == place; ++n)
                mean += neighbours_[n].probability * std::min(own(i), nearest[n]);
            smallest = std::min(smallest, mean);
        }
        return smallest;
    }

 private:
    const std::vector<Neighbour>& neighbours_;  // by offset
    std::size_t columns_;
    std::vector<double> nearest_;  // of each candidate: to each neighbour, and then to its own tile
};

// Cost: minus the mean squared distance to the nearest point so far.
std::vector<int> farthest_order(const std::vector<glm::dvec2>& placed, std::vector<glm::dvec2> positions,
                                const std::vector<Neighbour>& neighbours) {
    Candidates candidates(std::move(positions), -Distances::kFarther);
    Distances distances(candidates.size(), neighbours);
    std::vector<int> rank(candidates.size());
    const auto add = [&](glm::dvec2 p, double radius) {
        const auto add_copy = [&](glm::dvec2 copy, const auto& take) {
            candidates.for_each_near(copy, radius, [&](std::uint32_t i, double squared) {
                if (take(i, squared)) candidates.set_cost(i, -distances.mean(i));
            });
        };
        add_copy(p, [&](std::uint32_t i, double squared) { return distances.add_own(i, squared); });
        for (std::size_t n = 0; n < neighbours.size(); ++n)
            add_copy(position_in(neighbours[n], p),
                     [&](std::uint32_t i, double squared) { return distances.add(i, n, squared); });
    };
    // A neighbour's point farther away than the own tile's counts for nothing. The bound is found anew now
    // and then: it only shrinks.
    constexpr double kBetweenBounds = 1.05;  // of the count
    double count = static_cast<double>(placed.size()), bounded_at = 0, bound = std::sqrt(Distances::kFarther);
    const auto find_bound = [&] {
        if (count < kBetweenBounds * bounded_at) return;
        bounded_at = count;
        double farthest = 0;
        for (std::uint32_t i = 0; i < candidates.size(); ++i)
            if (candidates.is_waiting(i)) farthest = std::max(farthest, distances.own(i));
        bound = std::sqrt(farthest) * (1 + 1e-9);
    };
    // The placed points fill the tile: no candidate is farther from all of them than a few of their spacings.
    const double reach = placed.empty() ? 0 : 4 / std::sqrt(count);
    for (const glm::dvec2 p : placed) add(p, reach);
    for (std::size_t k = 0; k < rank.size(); ++k) {
        find_bound();
        const std::uint32_t next = candidates.cheapest();
        rank[next] = static_cast<int>(k);
        candidates.remove(next);
        add(candidates.position(next), bound);
        ++count;
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
