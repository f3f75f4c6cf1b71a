#include "core/placing/dot_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace dapple {

namespace {

constexpr int kMostDigits = 16;

// How often the page's square is halved until a square holds one dot of a threshold, or none: tiles of that
// level are 4^digits or fewer.
int digits_for(float threshold) {
    const int log2 = std::bit_width(static_cast<std::uint32_t>(std::clamp(threshold, 1.0f, 0x1p31f)));
    return std::min((log2 + 1) / 2, kMostDigits);
}

// The lowest `digits` of 16 bits, the last one in front.
std::uint32_t reversed(std::uint32_t v, int digits) {
    v = (v & 0x5555) << 1 | (v >> 1 & 0x5555);
    v = (v & 0x3333) << 2 | (v >> 2 & 0x3333);
    v = (v & 0x0f0f) << 4 | (v >> 4 & 0x0f0f);
    v = (v & 0x00ff) << 8 | (v >> 8 & 0x00ff);
    return v >> (16 - digits);
}

// A zero in front of each of 16 bits.
std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 8) & 0x00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
}

// The digits of a square's address, the last one in front, each as in Bayer's matrix of 2 x 2.
std::uint32_t dither_of(std::uint32_t column, std::uint32_t row, int digits) {
    return spread(reversed(column ^ row, digits)) << 1 | spread(reversed(row, digits));
}

}  // namespace

TieKey tie_key(float x, float y, float threshold) {
    const int digits = digits_for(threshold);
    const auto cell = [digits](float position) {
        const auto cells = static_cast<float>(1u << digits);
        return static_cast<std::uint32_t>(std::clamp(position * cells, 0.0f, cells - 1));
    };
    return {dither_of(cell(x), cell(y), digits),
            std::uint64_t{std::bit_cast<std::uint32_t>(y)} << 32 | std::bit_cast<std::uint32_t>(x)};
}

namespace {

constexpr int kHilbertDepth = 16;  // 2^16 cells along a side: finer than any pen

// The index of a cell along the Hilbert curve of that depth (Hilbert 1891), by turning the frame on the way
// down.
std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y) {
    std::uint32_t index = 0;
    for (std::uint32_t side = 1u << (kHilbertDepth - 1); side > 0; side >>= 1) {
        const std::uint32_t right = (x & side) != 0, lower = (y & side) != 0;
        index = index << 2 | ((3 * right) ^ lower);
        if (lower == 0) {
            if (right == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

// The square around all dots, in cells: they may lie anywhere, as on a page with a margin.
class HilbertGrid {
 public:
    explicit HilbertGrid(const Dots& dots) {
        if (dots.size() == 0) return;
        const auto [left, right] = std::ranges::minmax(dots.x);
        const auto [top, bottom] = std::ranges::minmax(dots.y);
        left_ = left;
        top_ = top;
        const float side = std::max(right - left, bottom - top);
        if (side > 0) cells_per_unit_ = kCells / side;
    }
    std::uint32_t index(float x, float y) const { return hilbert_index(cell(x - left_), cell(y - top_)); }

 private:
    static constexpr float kCells = 1 << kHilbertDepth;
    std::uint32_t cell(float from_edge) const {
        return static_cast<std::uint32_t>(std::clamp(from_edge * cells_per_unit_, 0.0f, kCells - 1));
    }

    float left_ = 0, top_ = 0, cells_per_unit_ = 0;
};

// Keys by which dots are sorted by priority, where some of them tie.
void sort_ties(const Dots& dots, std::vector<std::uint64_t>& keys) {
    const auto critical = [](std::uint64_t key) { return key >> 32; };
    const auto tie_of = [&](std::uint64_t key) {
        const auto i = static_cast<std::uint32_t>(key);
        return tie_key(dots.x[i], dots.y[i], dots.threshold[i]);
    };
    const auto first_by_tie = [&](std::uint64_t a, std::uint64_t b) { return tie_of(a) < tie_of(b); };
    for (auto first = keys.begin(); first != keys.end();) {
        const auto last = std::find_if(first, keys.end(),
                                       [&](std::uint64_t key) { return critical(key) != critical(*first); });
        if (last - first > 1) tbb::parallel_sort(first, last, first_by_tie);
        first = last;
    }
}

// Calls each(i) for all of so many dots, side by side.
void for_each_dot(std::size_t count, const auto& each) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 14), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) each(i);
    });
}

void rearrange(FloatBuffer& column, const std::vector<std::uint64_t>& keys) {
    FloatBuffer sorted(column.size());
    for_each_dot(keys.size(),
                 [&](std::size_t i) { sorted[i] = column[static_cast<std::uint32_t>(keys[i])]; });
    column = std::move(sorted);
}

}  // namespace

void sort_dots(Dots& dots, DotOrder order) {
    if (order == DotOrder::recursion) return;
    assert(order != DotOrder::priority ||
           (dots.threshold.size() == dots.size() && dots.critical.size() == dots.size()));
    if (dots.size() > std::numeric_limits<std::uint32_t>::max())
        throw std::runtime_error(
            "over 4,294,967,295 dots of one page cannot be put into an order; draw it in several sheets, or "
            "with --order recursion");
    std::vector<std::uint64_t> keys(dots.size());  // key above, index below
    const HilbertGrid grid(dots);
    for_each_dot(dots.size(), [&](std::size_t i) {
        // Positive floats are ordered as their bits are.
        const std::uint32_t key = order == DotOrder::priority ? std::bit_cast<std::uint32_t>(dots.critical[i])
                                                              : grid.index(dots.x[i], dots.y[i]);
        keys[i] = std::uint64_t{key} << 32 | i;
    });
    tbb::parallel_sort(keys.begin(), keys.end());
    if (order == DotOrder::priority) sort_ties(dots, keys);
    for (const auto column : kDotColumns) {
        if (!(dots.*column).empty()) rearrange(dots.*column, keys);
    }
}

}  // namespace dapple
