#pragma once
// How symmetric a tile is: its best tiles are "very symmetric", says the paper (section 5).

#include <array>

#include "core/tile/tile.h"

namespace dapple {

/// Two places count as one within so many mean spacings, 1 / sqrt(N).
inline constexpr double kSameSymmetricPlace = 0.1;

/// For each symmetry g of the square, by its index: the greatest share of the points that meet another point
/// when the tile, repeated endlessly as the paper's are, is turned by g and then moved. All moves that bring
/// some point onto another are tried, which finds every exact symmetry; for the identity those that leave
/// all where it is are left out. 1 for a lattice under each symmetry that it has, about 0.2 for sixteen
/// points at random.
std::array<double, 8> symmetry_shares(const Tile& tile);

/// The mean of the eight.
double symmetry(const Tile& tile);

}  // namespace dapple
