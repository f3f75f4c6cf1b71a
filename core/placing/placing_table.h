#pragma once
// A ranked tile, laid out for the placer.
//
// What a square of the page gets is told by the cell of the tile that falls on it and the tile's orientation
// there:
//
//      square (cell c, orientation g)  ->  its quadrant g(q):  (next_cell[q] of c, g * next_turn[q] of c)
//
// Making a square ready costs as much as testing some hundred points. So a cell brings up to about a thousand
// at once, by ascending rank: a tile of more than 64 points is cut into cells, a power of four of them, and
// below each cell several generations of newborn points are sorted into one subtree. Tiles of any size run
// through one recursion with the same pruning. The cells of a tile of several kinds follow each other, kind
// after kind; the root's come first.

#include <array>
#include <cstdint>
#include <vector>

#include "core/placing/dots.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

struct CellPoint {
    float x, y;  // from the cell's centre in half sides, -1..1
    float rank;  // in ranks
};

inline constexpr std::size_t kBlockPoints = 16;

/// Points as the kernels read them, one cache line after the other. What is not used has a rank of infinity.
struct alignas(64) PointBlock {
    float at[2][kBlockPoints];  // x, y
    float rank[kBlockPoints];
};

/// Points by ascending rank, which lie in a PointLists.
class CellPoints {
 public:
    std::size_t size() const { return size_; }
    CellPoint operator[](std::size_t i) const;
    float last_rank() const { return last_rank_; }
    /// The last is empty: there a kernel stops.
    const PointBlock* blocks() const { return blocks_; }
    /// Each block's last rank: infinity if it is not full.
    const float* block_ends() const { return block_ends_; }

 private:
    friend class PointLists;
    std::size_t size_ = 0;
    float last_rank_ = 0;
    const PointBlock* blocks_ = nullptr;
    const float* block_ends_ = nullptr;
};

/// Lists of points in one block of memory, which has huge pages if it is large: those of several kinds lie on
/// more small pages than a core keeps at hand, and placing would take a tenth longer.
class PointLists {
 public:
    PointLists() = default;
    /// Each by ascending rank.
    explicit PointLists(const std::vector<std::vector<CellPoint>>& lists);
    PointLists(PointLists&&) = default;
    PointLists& operator=(PointLists&&) = default;

    const CellPoints& operator[](std::size_t i) const { return lists_[i]; }

 private:
    std::vector<PointBlock, UnsetAllocator<PointBlock>> blocks_;
    std::vector<float> block_ends_;
    std::vector<CellPoints> lists_;
};

struct Cell {
    // Where the cell's quadrants lead to, by quadrant in the tile's frame.
    std::array<std::uint16_t, 4> next_cell{};
    std::array<Orientation, 4> next_turn{};
    std::array<float, 4> next_rank{};  // nothing is born in there before
    float first_next_rank = 0;         // the lowest of these
    CellPoints newborn;
    CellPoints subtree;     // the newborn points of the cell and of all squares some generations down
    float subtree_end = 0;  // further down nothing is born before, in this cell's ranks
    CellPoints all;  // of kind 0: the tile's own points, and after them the newborn ones, for the root tile
};

struct PlacingTable {
    std::size_t tile_size = 0;  // N
    int cell_depth = 0;         // cells are the tile's squares of this depth
    std::vector<Cell> cells;    // 4^cell_depth of each kind; the base-4 digits are the quadrants, outermost
                                // first
    PointLists points;          // of the cells
    Rule rule;
    NextKinds next_kind = NextKinds(1);
};

PlacingTable make_placing_table(const Tile& tile, const Ranking& ranking);

}  // namespace dapple
