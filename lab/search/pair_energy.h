#pragma once
// The energy of a point among the points of a tile and of all tiles that can lie beside it.
//
// Distances are in spacings, 1 / sqrt(N) of the tile's side. A pair at distance d has the energy
//
//      t (1 - d^2 / (4 w)^2)^8  +  c (1 - d^2 / r^2)^2,     each term only where its bracket is positive.
//
// The first is the Gaussian exp(-d^2 / (2 w^2)) with its tail cut smoothly: low where the tone is even. The
// second pushes apart the pairs closer than r. Polynomials cost no exponential and no root, and end, so that
// a grid of cells as wide as the larger reach finds every pair.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {

struct PairShape {
    double tone_width = 0.6;    // w, in spacings, above 0
    double close_weight = 3;    // c, 0 or more
    double close_radius = 0.8;  // r, in spacings, above 0
    double tone_weight = 1;     // t, 0 or more
};

/// The energy of a pair at a squared distance in spacings.
double pair_energy(const PairShape& shape, double squared_distance);

/// Points of a tile on a grid, with their copies in the neighbouring tiles, each weighted by how often that
/// neighbour occurs. Positions are in spacings from the tile's centre.
class EnergyGrid {
 public:
    /// The cells along a side of the tile, at least as wide as the energy's reach.
    static int cells_a_side(std::size_t tile_points, const PairShape& shape);

    /// `capacity`: the most points that a cell can hold; fits() tells.
    EnergyGrid(std::size_t tile_points, const std::vector<Neighbour>& neighbours, const PairShape& shape,
               int capacity);

    /// Whether a point can be added there.
    bool fits(glm::vec2 p) const;
    void insert(glm::vec2 p, std::uint32_t name);
    /// p must have been inserted under that name, to the bit.
    void remove(glm::vec2 p, std::uint32_t name);
    /// The energy of a point at p among all points in the grid and their copies; p itself not being in it.
    double energy(glm::vec2 p) const;
    /// Half of the energy of a point with its own copies; added to energy() it makes the sum over the points
    /// of a tile count every pair of a large subdivision once.
    double energy_with_itself(glm::vec2 p) const;
    /// The names of the tile's own points within a radius of p, which is at most the energy's reach.
    void find_near(glm::vec2 p, float radius, std::vector<std::uint32_t>& names) const;

 private:
    static constexpr int kLanes = 8;
    struct Block {
        std::array<float, kLanes> x, y, weight;
        std::array<std::uint32_t, kLanes> name;
    };
    struct Cell {
        std::uint32_t first_block = 0;
        std::int32_t count = 0;
    };
    struct Copy {
        std::array<float, 6> matrix;  // x' = m0 x + m1 y + m2, y' = m3 x + m4 y + m5
        glm::ivec2 offset;
        float weight;
    };

    int cell_of(glm::vec2 p) const;
    bool is_inner(int cell) const;
    void add(int cell, glm::vec2 p, float weight, std::uint32_t name);
    void take(int cell, glm::vec2 p, std::uint32_t name);
    template <class Visit>
    void for_copies(glm::vec2 p, Visit visit) const;

    int side_;      // cells a side of the tile; a ring of one cell lies around it
    int capacity_;  // of a cell of the tile
    float half_;    // of the tile's side, in spacings
    float cells_per_spacing_;
    float tone_, close_, tone_weight_, close_weight_;  // 1 / reach^2 and the weights
    std::vector<Copy> copies_;
    std::vector<Cell> cells_;
    std::vector<Block> blocks_;
};

}  // namespace dapple
