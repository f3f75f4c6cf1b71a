#pragma once
// Recursive Wang tiles: J. Kopf, D. Cohen-Or, O. Deussen & D. Lischinski, "Recursive Wang Tiles for Real-Time
// Blue Noise" (2006). Square tiles with coloured edges; a tile's points are ranked, and go over into those of
// the sixteen tiles that it is divided into.
//
// The set is our own, made here. What differs from the paper's: there are all 16 tiles of two colours an edge
// rather than 8; what lies along an edge of one colour is kept by fixing strips of points and filling the
// rest anew by best candidates and Lloyd's method, rather than by cutting along seams; ranks are by farthest
// point. As in the paper a tile's points stay where they are when it is divided, in the places of those of
// its children that are nearest. Those that no edge keeps are moved onto these, so only strips along the
// edges misfit.

#include <array>
#include <cstdint>
#include <vector>

#include "lab/related/wanted.h"

namespace dapple {

inline constexpr int kWangPoints = 1024;  // of a tile
inline constexpr int kWangDivision = 4;   // a tile has so many children across and down

struct WangTile {
    /// In the order of their ranks, within the unit square: the tile's own, and those that come when it is
    /// divided, 15 times as many.
    std::vector<glm::dvec2> first, later;
    std::array<std::uint8_t, kWangDivision * kWangDivision> children{};  // row after row, the top one first
};

/// The index of a tile says the colours of its edges: of the top edge in bit 0, then clockwise.
using WangTiles = std::vector<WangTile>;

/// All 16 tiles, made at the first call, which takes about two seconds.
const WangTiles& wang_tiles();

/// Dots where the density is above the rank's: exactly the count, and every prefix is a drawing. The tile at
/// the root has one colour, so that opposite edges meet. There is one set, whatever the seed.
PlainDots recursive_wang_tiles(const DotsWanted& wanted);

}  // namespace dapple
