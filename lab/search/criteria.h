#pragma once
// Numbers that tell how good a tile's pictures will be.
//
// F_g(k) below is the sum over the tile's points p, about its centre and turned by g, of exp(-2 pi i k .
// g(p)), with the tile's side as the unit; N is the number of points, and r_max = sqrt(1 / (2 sqrt(3) N)).
// The kinds of a tile of several count alike.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

/// Points of several kinds, to be found by kind and place.
class GridOfKinds {
 public:
    /// `kinds`: each point's kind, below `count`.
    GridOfKinds(const std::vector<glm::dvec2>& points, const std::vector<std::size_t>& kinds,
                std::size_t count)
        : numbers_(count) {
        std::vector<std::vector<glm::dvec2>> of_kind(count);
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            of_kind[kinds[i]].push_back(points[i]);
            numbers_[kinds[i]].push_back(i);
        }
        for (auto& kind : of_kind) grids_.emplace_back(std::move(kind), 0);
    }

    /// Calls visit(i, squared distance) for every point of a kind within a radius of a place.
    template <class Visit>
    void for_each_near(std::size_t kind, glm::dvec2 p, double radius, Visit visit) const {
        grids_[kind].for_each_near(
            p, radius, [&](std::uint32_t i, double squared) { visit(numbers_[kind][i], squared); });
    }

 private:
    std::vector<Candidates> grids_;
    std::vector<std::vector<std::uint32_t>> numbers_;
};

/// How many points lie in each quadrant. A balanced tile has N / 4 everywhere (section 5 of the paper).
std::array<int, 4> letter_counts(const Tile& tile);

/// Half the smallest distance between two points, over all legal neighbours, over r_max (section 5).
double relative_radius(const Tile& tile);

/// The lowest relative radius between two levels: of the tile's N points with the first k newborn ones of its
/// children in the order of their ranks, k = 0 .. 3 N, r_max being that of N + k points. Ranks that are
/// equal come together.
double worst_relative_radius(const Tile& tile, const Ranking& ranking);

/// How much of the spectrum repeats with every tile: the sum of |mean over g of F_g(k)|^2 over the sum of the
/// mean over g of |F_g(k)|^2, g being the orientations that the rule makes (only the identity for the paper's
/// tiles, which have 1), k the whole numbers with 0 < |k| <= 2 sqrt(N) and ky >= 0; and over all kinds.
/// Evenly mixed orientations bring it to about 1 over their number.
double coherent_share(const Tile& tile);

/// Unevenness of the tone: the mean of |F(k) - N sinc(kx) sinc(ky)|^2 / N over the multiples of 1/2 with
/// 0 < |k| <= sqrt(N) / 2; sinc(t) = sin(pi t) / (pi t) makes the mean density vanish. White noise has 1.
double low_frequency_power(const Tile& tile);

/// How near the tile is to a lattice: the greatest share of points p for which p + v is within 0.15 spacings
/// of another point, over all shifts v of 0.5 to 3 spacings; copies in legal neighbours count as often as
/// they occur. A lattice has 1.
double lattice_share(const Tile& tile);

/// How often tiles of the same size have equal orientations: for each lag d = 1..lags the highest share over
/// all vectors whose larger coordinate is d tiles, in an endless subdivision. 1 for the identity rule; 1/8
/// would be chance.
std::vector<double> orientation_coincidence(const Rule& rule, int lags = 64);

/// The same for tiles of one kind, of several, whatever their orientations; 1 / kinds would be chance.
std::vector<double> kind_coincidence(const NextKinds& next_kind, int lags = 32);

/// The same for a page: one tile of kind 0, divided so often, 1..10, whose edges meet their opposites. The
/// share of its tiles that lie on one of their kind when the page is moved by whole tiles, 0..1; the highest
/// of all moves.
double page_coincidence(const NextKinds& next_kind, int divisions);

}  // namespace dapple
