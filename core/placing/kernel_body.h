// The placer's inner loop over one square, included by a file for each vector width. Before it stand, in an
// unnamed namespace, types `Lanes` of kWidth floats and `Whole` of as many integers with the operations used
// below, and nothing else, so that no shared inline function is ever compiled for a processor that is not
// there.

#include "core/placing/kernel.h"

namespace {

using dapple::CertainPoints;
using dapple::kBlockPoints;
using dapple::KernelOutput;
using dapple::KernelSquare;
using dapple::PlacedCount;
using dapple::PointBlock;
using Source = KernelSquare::Source;

inline Mask in_edges(const KernelSquare& s, Lanes x, Lanes y) {
    const Lanes X = x * Lanes(s.sign_x), Y = y * Lanes(s.sign_y);
    return both(without(Lanes(s.high_x) > X, Lanes(s.low_x) > X),
                without(Lanes(s.high_y) > Y, Lanes(s.low_y) > Y));
}

template <Source kSource>
[[gnu::always_inline]] inline Lanes density_at(const KernelSquare& s, const Block& block, Lanes x, Lanes y) {
    const PixelPosition u = pixel_position(s.pixel_centre_x, s.pixel_half_x, x);
    const PixelPosition v = pixel_position(s.pixel_centre_y, s.pixel_half_y, y);
    const Square4 t = kSource == Source::block     ? from_block(s, block, u.pixel, v.pixel)
                      : kSource == Source::picture ? from_picture(s, u.pixel, v.pixel)
                                                   : from_clamped(s, u.pixel, v.pixel);
    const Lanes right = u.fraction * Lanes(s.mixed), below = v.fraction * Lanes(s.mixed);
    const Lanes upper = t.v00 + (t.v10 - t.v00) * right;
    const Lanes lower = t.v01 + (t.v11 - t.v01) * right;
    return upper + (lower - upper) * below;
}

// A store that waits for memory soon blocks the loads behind it. At one point of each block; `at` is the next
// dot to be written. Inlined always, since GCC takes a function that only prefetches for one without effect.
[[gnu::always_inline]] inline void ask_for_lines(const KernelOutput& out, std::size_t point, std::size_t at) {
    constexpr std::size_t kAhead = 512;  // dots: 100 ns and more
    if (!out.beyond_caches || point % kBlockPoints != 0) return;
    __builtin_prefetch(out.x + at + kAhead, 1);
    __builtin_prefetch(out.y + at + kAhead, 1);
}

// The tail is short: one by one.
inline void list_tail(Mask tail, Mask exists, Lanes threshold, Lanes density, const KernelOutput& out,
                      PlacedCount& placed) {
    float thresholds[kWidth], criticals[kWidth];
    store(thresholds, threshold);
    store(criticals, threshold / density);
    for (unsigned bits = bits_of(tail); bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctz(bits);
        const unsigned before = bits_of(exists) & ((1u << lane) - 1);
        out.tail[placed.tail++] = {
            out.first_index + placed.dots + static_cast<std::size_t>(__builtin_popcount(before)),
            thresholds[lane], criticals[lane]};
    }
}

template <Source kSource, bool kThresholds, bool kTail>
inline PlacedCount place_points(const KernelSquare& square, const KernelOutput& output) {
    const KernelSquare s = square;  // copies: no store can change them, so that they stay in registers
    const KernelOutput out = output;
    const std::size_t swap = s.swap;
    const Block block = load_block(s.block);
    PlacedCount placed{.dots = s.first, .tail = 0};
    for (std::size_t i = s.first;; i += kWidth) {
        const PointBlock& points = s.points[i / kBlockPoints];
        const std::size_t at = i % kBlockPoints;
        if (!(points.rank[at] < s.none_from)) return placed;
        ask_for_lines(out, i, placed.dots);
        const Lanes rank = load(points.rank + at);
        const Lanes x = load(points.at[swap] + at), y = load(points.at[1 - swap] + at);
        const Lanes page_x = Lanes(s.centre_x) + Lanes(s.half_x) * x;
        const Lanes page_y = Lanes(s.centre_y) + Lanes(s.half_y) * y;
        if (!kThresholds && !s.at_edge && points.rank[at + kWidth - 1] < s.certain_below) {
            store(out.x + placed.dots, page_x);
            store(out.y + placed.dots, page_y);
            placed.dots += kWidth;
            continue;
        }
        const Lanes density = density_at<kSource>(s, block, x, y);
        Mask exists = density * Lanes(s.ranks_per_density) > rank;
        if (s.at_edge) exists = both(exists, in_edges(s, x, y));
        const Lanes threshold = rank * Lanes(s.threshold_per_rank);
        if (kTail) {
            const Mask tail = without(exists, density * Lanes(s.tail_per_density) > rank);
            if (bits_of(tail) != 0) list_tail(tail, exists, threshold, density, out, placed);
        }
        pack(out.x + placed.dots, page_x, exists);
        pack(out.y + placed.dots, page_y, exists);
        if (kThresholds) {
            pack(out.threshold + placed.dots, threshold, exists);
            pack(out.critical + placed.dots, threshold / density, exists);
        }
        placed.dots += static_cast<std::size_t>(__builtin_popcount(bits_of(exists)));
    }
}

CertainPoints place_certain(const KernelSquare& square, const KernelOutput& output) {
    const KernelSquare s = square;
    const KernelOutput out = output;
    const std::size_t swap = s.swap;
    const auto place = [&](std::size_t i, const PointBlock& points, std::size_t at) {
        const Lanes x = load(points.at[swap] + at), y = load(points.at[1 - swap] + at);
        store(out.x + i, Lanes(s.centre_x) + Lanes(s.half_x) * x);
        store(out.y + i, Lanes(s.centre_y) + Lanes(s.half_y) * y);
    };
    std::size_t first = 0;
    for (; s.block_ends[first / kBlockPoints] < s.certain_below; first += kBlockPoints) {
        ask_for_lines(out, first, first);
        const PointBlock& points = s.points[first / kBlockPoints];
        for (std::size_t at = 0; at < kBlockPoints; at += kWidth) place(first + at, points, at);
    }
    for (std::size_t i = first;; i += kWidth) {
        const PointBlock& points = s.points[i / kBlockPoints];
        const std::size_t at = i % kBlockPoints;
        if (points.rank[at + kWidth - 1] < s.certain_below) {
            place(i, points, at);
            continue;
        }
        const Lanes rank = load(points.rank + at);
        const unsigned certain = bits_of(Lanes(s.certain_below) > rank);
        if (certain != bits_of(Lanes(s.none_from) > rank)) return {i, false};
        place(i, points, at);
        return {i + static_cast<std::size_t>(__builtin_popcount(certain)), true};
    }
}

template <bool kThresholds, bool kTail>
inline PlacedCount place_square(const KernelSquare& s, const KernelOutput& out) {
    switch (s.source) {
        case Source::block:
            return place_points<Source::block, kThresholds, kTail>(s, out);
        case Source::picture:
            return place_points<Source::picture, kThresholds, kTail>(s, out);
        case Source::clamped:
            return place_points<Source::clamped, kThresholds, kTail>(s, out);
    }
    return {};
}

PlacedCount place_square(const KernelSquare& s, const KernelOutput& out) {
    if (out.tail) return out.critical ? place_square<true, true>(s, out) : place_square<false, true>(s, out);
    return out.critical ? place_square<true, false>(s, out) : place_square<false, false>(s, out);
}

}  // namespace
