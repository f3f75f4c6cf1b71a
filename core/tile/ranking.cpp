#include "core/tile/ranking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/maths/portable_math.h"

namespace dapple {

Candidates::Candidates(std::vector<glm::dvec2> positions, double cost)
    : positions_(std::move(positions)), cost_(positions_.size(), cost), waiting_(positions_.size(), true) {
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(size()) / 2)));
    const auto cell_of = [&](glm::dvec2 p) {
        return static_cast<std::size_t>(cell_on_axis(p.y)) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(cell_on_axis(p.x));
    };
    first_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (const glm::dvec2 p : positions_) ++first_[cell_of(p) + 1];
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    std::vector<std::uint32_t> next = first_;
    members_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) members_[next[cell_of(positions_[i])]++] = i;

    while (leaves_ < size()) leaves_ *= 2;
    winner_.resize(2 * leaves_);
    set_costs(cost_);
}

int Candidates::cell_on_axis(double v) const {
    return static_cast<int>(std::clamp(std::floor(v * side_), 0.0, side_ - 1.0));
}

std::uint32_t Candidates::better(std::uint32_t a, std::uint32_t b) const {
    if (b >= size() || !waiting_[b]) return a;
    if (a >= size() || !waiting_[a]) return b;
    // Equal up to rounding counts as equal, so that the order is the same everywhere.
    return cost_[b] < cost_[a] - 1e-12 * std::abs(cost_[a]) ? b : a;
}

void Candidates::set_cost(std::uint32_t i, double cost) {
    cost_[i] = cost;
    for (std::uint32_t node = (leaves_ + i) / 2; node > 0; node /= 2)
        winner_[node] = better(winner_[2 * node], winner_[2 * node + 1]);
}

void Candidates::set_costs(std::vector<double> costs) {
    cost_ = std::move(costs);
    for (std::uint32_t i = 0; i < leaves_; ++i) winner_[leaves_ + i] = i;
    for (std::uint32_t node = leaves_ - 1; node > 0; --node)
        winner_[node] = better(winner_[2 * node], winner_[2 * node + 1]);
}

void Candidates::remove(std::uint32_t i) {
    waiting_[i] = false;
    set_cost(i, cost_[i]);
}

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

    /// Takes note of a candidate's squared distance to a point of its own tile. True if none was nearer.
    bool add_own(std::uint32_t i, double squared) { return add(i, neighbours_.size(), squared); }
    /// The same for a point of one of the neighbours.
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
// denser. All kinds go on together, point by point; `placed` and `positions` are theirs, kind after kind, and
// equally many of each. Candidates of a lower stage come first, if stages are given.
std::vector<int> energy_order(const std::vector<glm::dvec2>& placed, const std::vector<glm::dvec2>& positions,
                              const std::vector<std::vector<Neighbour>>& copies,
                              std::span<const int> stage = {}) {
    // A small tile's copies are alike, and a wide Gaussian keeps their rows even; a large one does better
    // with closer looks, and is spared some of the work.
    constexpr double kStageCost = 1e4;  // far above any energy
    const std::size_t kinds = copies.size(), size = positions.size() / kinds;
    const bool small = (placed.size() + positions.size()) / kinds < 500;
    const double width = small ? 0.62 : 0.5;   // of the mean spacing at the count
    const double growth = small ? 1.0 : 1.05;  // of the count between two narrowings
    const double reach_in_widths = small ? 7 : 4.3;
    std::vector<std::vector<glm::dvec2>> there(kinds);
    std::vector<Candidates> candidates;
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto share = [&](const std::vector<glm::dvec2>& all) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(k * all.size() / kinds);
            return std::vector<glm::dvec2>(first, first + static_cast<std::ptrdiff_t>(all.size() / kinds));
        };
        there[k] = share(placed);
        candidates.emplace_back(share(positions), 0);
    }
    std::vector<int> rank(positions.size());

    double falloff = 0, reach = 0, narrowed_at = 0;
    const auto spread = [&](glm::dvec2 p, std::size_t kind, auto add) {
        for_copies(p, kind, copies[kind], reach, [&](glm::dvec2 copy, double probability, std::size_t of) {
            candidates[of].for_each_near(copy, reach, [&](std::uint32_t i, double squared) {
                add(of, i, probability * portable::exp(-falloff * squared));
            });
        });
    };
    const auto narrow = [&](double count) {
        narrowed_at = count;
        falloff = count / (2 * width * width);
        reach = reach_in_widths * width / std::sqrt(count);
        std::vector<std::vector<double>> costs(kinds, std::vector<double>(size, 0.0));
        for (std::size_t i = 0; i < stage.size(); ++i) costs[i / size][i % size] = kStageCost * stage[i];
        for (std::size_t k = 0; k < kinds; ++k) {
            for (const glm::dvec2 p : there[k]) {
                spread(p, k, [&](std::size_t of, std::uint32_t i, double energy) { costs[of][i] += energy; });
            }
        }
        for (std::size_t k = 0; k < kinds; ++k) candidates[k].set_costs(std::move(costs[k]));
    };
    for (std::size_t r = 0; r < size; ++r) {
        const auto count = static_cast<double>(there[0].size() + 1);
        if (count >= growth * narrowed_at) narrow(count);
        for (std::size_t k = 0; k < kinds; ++k) {
            const std::uint32_t next = candidates[k].cheapest();
            rank[k * size + next] = static_cast<int>(r);
            candidates[k].remove(next);
            there[k].push_back(candidates[k].position(next));
            spread(there[k].back(), k, [&](std::size_t of, std::uint32_t i, double energy) {
                candidates[of].set_cost(i, candidates[of].cost(i) + energy);
            });
        }
    }
    return rank;
}

std::vector<glm::dvec2> positions_of(const Tile& tile) {
    std::vector<glm::dvec2> positions;
    for (const BinaryPoint p : tile.points) positions.push_back(to_unit_square(p));
    return positions;
}

std::vector<glm::dvec2> positions_of_newborns(const Tile& tile) {
    std::vector<glm::dvec2> positions;
    for (const Newborn& n : newborns_of(tile)) positions.push_back(to_unit_square(n.position));
    return positions;
}

std::vector<float> half_way(const std::vector<int>& ranks, float first) {
    std::vector<float> result;
    for (const int rank : ranks) result.push_back(first + static_cast<float>(rank) + 0.5f);
    return result;
}

}  // namespace

std::vector<int> farthest_point_ranks(const Tile& tile) {
    if (tile.kinds() > 1)
        throw std::runtime_error("a tile of several kinds is ranked by energy only; choose that ranking");
    return farthest_order({}, positions_of(tile), legal_neighbours(tile.rule));
}

std::vector<float> rank_newborns_in_stages(const Tile& tile, std::span<const int> stage) {
    return half_way(
        energy_order(positions_of(tile), positions_of_newborns(tile), copies_of_kinds(tile), stage),
        static_cast<float>(tile.size()));
}

std::size_t born_until(std::size_t tile_size, int stage) {
    const auto n = static_cast<double>(tile_size);
    const double there = n * portable::pow(4.0, static_cast<double>(stage + 1) / kRankStages);
    return static_cast<std::size_t>(std::llround(there - n));
}

std::vector<int> stages_of_ranks(std::size_t tile_size, std::span<const float> newborn_ranks) {
    std::vector<int> stages;
    stages.reserve(newborn_ranks.size());
    for (const float rank : newborn_ranks) {
        int stage = 0;
        while (rank - static_cast<float>(tile_size) > static_cast<float>(born_until(tile_size, stage)))
            ++stage;
        stages.push_back(stage);
    }
    return stages;
}

std::vector<float> ranks_of_stages(std::size_t tile_size, std::span<const int> stages) {
    // Points lie in the order of their squares' digits; read backwards, these tell far from near.
    const auto scattered = [](std::size_t i, std::size_t count) {
        constexpr int kDigits = 16;
        std::uint64_t digits = (std::uint64_t{i} << (2 * kDigits)) / count, backwards = 0;
        for (int d = 0; d < kDigits; ++d, digits >>= 2) backwards = backwards << 2 | (digits & 3);
        return backwards;
    };
    std::vector<float> ranks(stages.size());
    const std::size_t newborns = 3 * tile_size;
    for (std::size_t first = 0; first < stages.size(); first += newborns) {
        std::array<std::vector<std::size_t>, kRankStages> members;
        for (std::size_t i = first; i < first + newborns; ++i)
            members[static_cast<std::size_t>(stages[i])].push_back(i);
        std::size_t rank = tile_size;
        for (const std::vector<std::size_t>& stage : members) {
            std::vector<std::pair<std::uint64_t, std::size_t>> order;
            for (std::size_t i = 0; i < stage.size(); ++i)
                order.emplace_back(scattered(i, stage.size()), stage[i]);
            std::ranges::sort(order);
            for (const auto& [key, i] : order) ranks[i] = static_cast<float>(rank++) + 0.5f;
        }
    }
    return ranks;
}

std::vector<float> paper_newborn_ranks(const Tile& tile, std::span<const float> tile_ranks) {
    std::vector<float> ranks;
    for (const Newborn& n : newborns_of(tile))
        ranks.push_back(static_cast<float>(tile.size()) + 3 * tile_ranks[n.point]);
    return ranks;
}

Ranking rank(const Tile& tile, RankingMethod method) {
    const auto own = positions_of(tile), born = positions_of_newborns(tile);
    const float count = static_cast<float>(tile.size());
    if (method == RankingMethod::energy) {
        const auto copies = copies_of_kinds(tile);
        const std::vector<float> newborn = half_way(energy_order(own, born, copies), count);
        if (tile.kinds() == 1) return {half_way(energy_order({}, own, copies), 0), newborn};
        // The root lies beside nothing but itself, where a drawing repeats.
        const std::vector<glm::dvec2> root(own.begin(),
                                           own.begin() + static_cast<std::ptrdiff_t>(tile.size()));
        return {half_way(energy_order({}, root, {legal_neighbours(Rule{})}), 0),
                ranks_of_stages(tile.size(), stages_of_ranks(tile.size(), newborn))};
    }
    Ranking ranking{half_way(farthest_point_ranks(tile), 0), {}};
    if (method == RankingMethod::farthest)
        ranking.newborn = half_way(farthest_order(own, born, legal_neighbours(tile.rule)), count);
    else
        ranking.newborn = paper_newborn_ranks(tile, ranking.tile);
    return ranking;
}

}  // namespace dapple
