#pragma once
// A ranked tile, laid out for the placer.
//
// A tile of N > 16 points is cut into cells, a power of four of them, so that each holds about 16 points and
// 48 newborn ones. What a square of the page gets is then told by the cell that falls on it and the tile's
// orientation there:
//
//      square (cell c, orientation g)  ->  its quadrant g(q):  (next_cell[q] of c, g * next_turn[q] of c)
//
// so that tiles of any size run through one recursion with the same pruning. A tile of 16 is one cell.

#include <array>
#include <cstdint>
#include <vector>

#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

/// Points relative to a cell's centre in half sides, -1..1, by ascending birth; padded for the kernels with
/// births of infinity.
struct CellPoints {
    std::size_t count = 0;  // without the padding
    std::vector<float> x, y, birth;
};

/// Appends the padding to columns of `count` points.
void pad(CellPoints& points);

struct Cell {
    CellPoints newborn;
    CellPoints own;                            // the tile's own points: placed once, in the root
    std::array<std::uint16_t, 4> next_cell{};  // by quadrant in the tile's frame
    std::array<Orientation, 4> next_turn{};
};

struct PlacingTable {
    std::size_t tile_size = 0;  // N
    int cell_depth = 0;         // cells are the tile's squares of this depth
    std::vector<Cell> cells;    // 4^cell_depth; the index's base-4 digits are the quadrants, outermost first
    Rule rule;
};

PlacingTable make_placing_table(const Tile& tile, const Ranking& ranking);

}  // namespace dapple
