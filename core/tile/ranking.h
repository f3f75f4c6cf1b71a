#pragma once
// The order in which a tile's points, and then its children's, appear as the density rises.
//
// A rank is a place in that order: with n = density in dots per tile, a tile shows its points of rank < n.
// Rank 0..N belongs to the tile's own N points, N..4N to the 3 N newborn ones of its four children, where
// the children together are the complete tile of the next level. On level l of a subdivision a dot of rank b
// needs scale * density > 4^l * b / 16.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/text/names.h"
#include "core/tile/tile.h"

namespace dapple {

// Points of the unit square that wait to be chosen, each with a cost: found by place, cheapest first.

class Candidates {
 public:
    /// All candidates begin with the same cost.
    Candidates(std::vector<glm::dvec2> positions, double cost);

    std::size_t size() const { return positions_.size(); }
    glm::dvec2 position(std::uint32_t i) const { return positions_[i]; }
    double cost(std::uint32_t i) const { return cost_[i]; }

    /// The cheapest candidate; of costs that are equal but for rounding the first. There must be one left.
    std::uint32_t cheapest() const { return winner_[1]; }
    void set_cost(std::uint32_t i, double cost);
    /// Sets all costs, which is faster than one by one.
    void set_costs(std::vector<double> costs);
    /// Takes a candidate out for good.
    void remove(std::uint32_t i);
    bool is_waiting(std::uint32_t i) const { return waiting_[i]; }

    /// Calls visit(i, squared distance) for every waiting candidate within a radius of a place, inside or
    /// outside the square.
    template <class Visit>
    void for_each_near(glm::dvec2 p, double radius, Visit visit) const;

 private:
    std::uint32_t better(std::uint32_t a, std::uint32_t b) const;
    int cell_on_axis(double v) const;

    std::vector<glm::dvec2> positions_;
    std::vector<double> cost_;
    std::vector<bool> waiting_;
    std::uint32_t leaves_ = 1;           // of the tree of winners, a power of two
    std::vector<std::uint32_t> winner_;  // node k has the children 2 k and 2 k + 1; the root is 1
    int side_ = 1;                       // cells a side
    std::vector<std::uint32_t> first_;   // of each cell in members_
    std::vector<std::uint32_t> members_;
};

template <class Visit>
void Candidates::for_each_near(glm::dvec2 p, double radius, Visit visit) const {
    const int x0 = cell_on_axis(p.x - radius), x1 = cell_on_axis(p.x + radius);
    const int y0 = cell_on_axis(p.y - radius), y1 = cell_on_axis(p.y + radius);
    for (int y = y0; y <= y1; ++y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(side_);
        for (std::uint32_t k = first_[row + x0]; k < first_[row + x1 + 1]; ++k) {
            const std::uint32_t i = members_[k];
            const glm::dvec2 d = positions_[i] - p;
            const double squared = d.x * d.x + d.y * d.y;
            if (squared <= radius * radius && waiting_[i]) visit(i, squared);
        }
    }
}

enum class RankingMethod {
    paper,     // each tile ranked by itself, newborn points by their rank in their own tile (section 6)
    farthest,  // newborn points of all four children together, farthest point first, inherited ones counted
    energy,    // as farthest, but lowest Gaussian energy first: evener tone
};
constexpr auto names_of(RankingMethod) {
    return names("paper", "farthest", "energy");
}

struct Ranking {
    std::vector<float> tile;     // N ranks of the tile's points; of several kinds those of kind 0, the root's
    std::vector<float> newborn;  // 3 N ranks of each kind, in the order of newborns_of()
};

/// Ranks a tile. Where a neighbour may be oriented in several ways or of several kinds, distances (squared)
/// to the nearest of its points and energies are means over them, as often as they occur. All kinds are
/// ranked together, as many points of each at any density, and their ranks are those of ranks_of_stages();
/// that has only the energy, and std::runtime_error is thrown by the other methods.
Ranking rank(const Tile& tile, RankingMethod method);

/// The paper's newborn ranks from the ranks of a tile's own points: a child of density 1..4 parents shows
/// the ranks below N (n / N - 1) / 3 of its own.
std::vector<float> paper_newborn_ranks(const Tile& tile, std::span<const float> tile_ranks);

/// Greedy farthest-point order (section 6; Eldar et al. 1997): the ranks 0..N-1 of the tile's points, the
/// first point having rank 0. With the identity rule, on the torus, this is the permutation of Appendix A.
/// For tiles of one kind only: throws std::runtime_error otherwise.
std::vector<int> farthest_point_ranks(const Tile& tile);

/// The ranks of the newborn points in an order that takes them stage by stage, a whole number for each in
/// the order of newborns_of(), and within a stage lowest energy first.
std::vector<float> rank_newborns_in_stages(const Tile& tile, std::span<const int> stage);

/// Many points need few bits each: the newborn points of several kinds are ranked by stages, at the ends of
/// which a tile has N 4^(1/16), N 4^(2/16), ... 4 N points. Within a stage they come scattered over the tile.
inline constexpr int kRankStages = 16;

/// The stages 0 .. kRankStages - 1 of newborn points that have these ranks.
std::vector<int> stages_of_ranks(std::size_t tile_size, std::span<const float> newborn_ranks);

/// How many newborn points of a kind are born before the end of a stage.
std::size_t born_until(std::size_t tile_size, int stage);

/// The ranks that go with stages. Each kind must have as many points in a stage as born_until() says.
std::vector<float> ranks_of_stages(std::size_t tile_size, std::span<const int> stages);

}  // namespace dapple
