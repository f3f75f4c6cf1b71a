#pragma once
// What a placer gives: positions, and for each dot the scale at which it appears.

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace dapple {

// Memory for columns of many numbers.

inline constexpr std::size_t kLargeMemory = 4 << 20;

/// Memory of kLargeMemory and more, in huge pages where it is Linux that has them: there, fresh memory and
/// writing through a hundred megabytes cost less. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);
void deallocate_large(void* memory);

/// Leaves numbers unset when a vector grows: a million dots a frame are written once, not twice.
template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    T* allocate(std::size_t count) {
        if (count < kLargeMemory / sizeof(T)) return std::allocator<T>::allocate(count);
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_large(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) {
        if (count < kLargeMemory / sizeof(T)) return std::allocator<T>::deallocate(memory, count);
        deallocate_large(memory);
    }
    template <class U>
    void construct(U* place) noexcept {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};
using FloatBuffer = std::vector<float, UnsetAllocator<float>>;

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

/// For whatever is done to all of them alike.
inline constexpr FloatBuffer Dots::*kDotColumns[] = {&Dots::x, &Dots::y, &Dots::threshold, &Dots::critical,
                                                     &Dots::radius};

void append(Dots& to, const Dots& more);

/// Leaves the dots for which keeps(index) is true, as they were.
template <class Keeps>
void leave(Dots& dots, const Keeps& keeps) {
    std::size_t left = 0;
    const std::size_t all = dots.size();
    for (std::size_t i = 0; i < all; ++i) {
        if (!keeps(i)) continue;
        for (const auto column : kDotColumns)
            if (!(dots.*column).empty()) (dots.*column)[left] = (dots.*column)[i];
        ++left;
    }
    for (const auto column : kDotColumns)
        if (!(dots.*column).empty()) (dots.*column).resize(left);
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
