#pragma once
// The order in which a tile's points, and then its children's, appear as the density rises.
//
// A rank is a place in that order: with n = density in dots per tile, a tile shows its points of rank < n.
// Rank 0..N belongs to the tile's own N points, N..4N to the 3 N newborn ones of its four children, where
// the children together are the complete tile of the next level. On level l of a subdivision a dot of rank b
// needs scale * density > 4^l * b / 16.

#include <span>
#include <string_view>
#include <vector>

#include "core/text/names.h"
#include "core/tile/neighbours.h"
#include "core/tile/tile.h"

namespace dapple {

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
