#pragma once
// What a placer gives: positions, and for each dot the scale at which it appears.

#include <cstddef>
#include <vector>

#include "core/placing/large_memory.h"

namespace dapple {

/// Dots as columns of equal length; those that say when a dot appears are empty unless asked for, and radii
/// are where all dots are alike.
struct Dots {
    FloatBuffer x, y;  // page units, from the window's origin
    FloatBuffer
        threshold;         // the dot exists where scale * density > threshold; says level and rank, see below
    FloatBuffer critical;  // critical scale: the dot exists at scales above this
    FloatBuffer radius;    // page units
    int pen = 0;           // that draws all of them: its place in the drawing's palette

    std::size_t size() const { return x.size(); }
    /// Leaves no radii.
    void resize(std::size_t count, bool thresholds);
    void reserve(std::size_t count, bool thresholds);
};

void append(Dots& to, const Dots& more);

/// Leaves the dots for which keeps(index) is true, as they were.
template <class Keeps>
void leave(Dots& dots, const Keeps& keeps) {
    FloatBuffer* const columns[] = {&dots.x, &dots.y, &dots.threshold, &dots.critical, &dots.radius};
    std::size_t left = 0;
    const std::size_t all = dots.size();
    for (std::size_t i = 0; i < all; ++i) {
        if (!keeps(i)) continue;
        for (FloatBuffer* const column : columns)
            if (!column->empty()) (*column)[left] = (*column)[i];
        ++left;
    }
    for (FloatBuffer* const column : columns)
        if (!column->empty()) column->resize(left);
}

/// A drawing's dots in their order, piece after piece: threads place them side by side, and nothing is moved
/// afterwards. Pieces may be empty.
struct DotPieces {
    std::vector<Dots> pieces;

    std::size_t size() const;  // dots in all
};

/// Calls visit(x, y) for each dot.
template <class Visit>
void for_each_position(const DotPieces& dots, const Visit& visit) {
    for (const Dots& piece : dots.pieces) {
        for (std::size_t i = 0; i < piece.size(); ++i) visit(piece.x[i], piece.y[i]);
    }
}

DotPieces in_one_piece(Dots dots);

/// A dot among others, and when it appears.
struct TailDot {
    std::size_t index;
    float threshold, critical;
};
using TailDots = std::vector<TailDot, UnsetAllocator<TailDot>>;

/// Which point of which tile a dot is.
struct TileRank {
    // 0: a point of the root tile; l: a newborn point of the children of a tile of level l - 1
    int level = 0;
    int rank = 0;  // level 0: 0..N-1; else N..4N-1, the joint order of those newborn points
};

/// A threshold is rank + 1/2, over 16, times 4^(level - 1) from level 1 on: it says both. N is the tile's
/// size.
TileRank tile_rank_of(float threshold, std::size_t tile_size);

/// The same for a dot that Figure 8 emits: its rank is 0..N-1 in a tile of any level, as in the paper's
/// table 1. It spreads each tile's N thresholds over those of ranks N..4N, at the root tile too.
TileRank figure8_rank_of(float threshold, std::size_t tile_size);

}  // namespace dapple
