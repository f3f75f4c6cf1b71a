#pragma once
// One dot's Voronoi cell: the part of a rectangle around it that is nearer to it than to any other dot.

#include <bit>
#include <cstdint>
#include <cstring>

namespace dapple {

/// A convex polygon seen from its dot at (0, 0), its corners clockwise where y points down. Single precision:
/// which dots cut it, and in which order, decides about its last bits.
class VoronoiCell {
 public:
    /// A rectangle with the dot in it.
    VoronoiCell(float left, float top, float right, float bottom) {
        for (int i = 4; i < 8; ++i) set(i, 0, 0);
        set(0, left, top);
        set(1, right, top);
        set(2, right, bottom);
        set(3, left, bottom);
        find_reach();
    }

    int size() const { return size_; }
    float x(int corner) const { return x_[corner]; }
    float y(int corner) const { return y_[corner]; }

    /// The square of the distance from which on other dots leave the cell as it is: twice the farthest
    /// corner's.
    float reach2() const { return reach2_; }

    /// Cuts off what is nearer to another dot; not the same place.
    [[gnu::always_inline]] inline void cut(float other_x, float other_y) {
        // Beyond the bisector: x * other_x + y * other_y > half the square of the distance.
        const float half = 0.5f * (other_x * other_x + other_y * other_y);
        float beyond[kRoom];
        std::uint32_t outside = 0;
        for (int first = 0; first < size_; first += 8) {
            int bits[8];
            for (int i = 0; i < 8; ++i) {
                beyond[first + i] = x_[first + i] * other_x + y_[first + i] * other_y - half;
                bits[i] = beyond[first + i] > 0 ? 1 << i : 0;
            }
            int all = 0;
            for (const int bit : bits) all |= bit;
            outside |= static_cast<std::uint32_t>(all) << first;
        }
        outside &= (1u << size_) - 1;
        if (outside != 0) cut_off(outside, beyond);
    }

 private:
    static constexpr int kMost = 24;         // corners
    static constexpr int kRoom = kMost + 8;  // so that eight can be read or moved at once

    void set(int corner, float x, float y) {
        x_[corner] = x;
        y_[corner] = y;
        distance2_[corner] = x * x + y * y;
    }

    // Moves corners from one place on to another.
    void move(int from, int to) {
        for (float* numbers : {x_, y_, distance2_}) {
            if (size_ <= 8) {
                float eight[8];
                std::memcpy(eight, numbers + from, sizeof eight);
                std::memcpy(numbers + to, eight, sizeof eight);
            } else {
                std::memmove(numbers + to, numbers + from, sizeof(float) * static_cast<unsigned>(size_ - from));
            }
        }
    }

    // The corners outside follow each other; the edges at both ends are cut.
    [[gnu::always_inline]] inline void cut_off(std::uint32_t outside, const float* beyond) {
        const std::uint32_t all = (1u << size_) - 1;
        if (outside == all) return;  // which rounding alone can bring about
        const bool wraps = (outside & 1) != 0 && (outside >> (size_ - 1) & 1) != 0;
        // The run of corners outside: from `first` to before `end`, past the last corner where it wraps.
        const int first = wraps ? std::bit_width(~outside & all) : std::countr_zero(outside);
        const int end = wraps ? std::countr_zero(~outside) : std::bit_width(outside);
        const int from = first == 0 ? size_ - 1 : first - 1;
        const int last = end == 0 ? size_ - 1 : end - 1, to = end == size_ ? 0 : end;
        const float leaving = beyond[from] / (beyond[from] - beyond[first]);
        const float leaving_x = x_[from] + (x_[first] - x_[from]) * leaving;
        const float leaving_y = y_[from] + (y_[first] - y_[from]) * leaving;
        const float entering = beyond[to] / (beyond[to] - beyond[last]);
        const float entering_x = x_[to] + (x_[last] - x_[to]) * entering;
        const float entering_y = y_[to] + (y_[last] - y_[to]) * entering;
        int at;  // of the two new corners
        if (wraps) {
            at = first - end;
            move(end, 0);
            size_ = at + 2;
        } else {
            at = first;
            const int size = size_ - (end - first) + 2;
            if (size > kMost) return;  // no dot has so many neighbours
            if (end < size_) move(end, first + 2);
            size_ = size;
        }
        set(at, leaving_x, leaving_y);
        set(at + 1, entering_x, entering_y);
        find_reach();
    }

    void find_reach() {
        float farthest2 = distance2_[0];
        for (int i = 1; i < size_; ++i) farthest2 = distance2_[i] > farthest2 ? distance2_[i] : farthest2;
        reach2_ = 4 * farthest2;
    }

    float x_[kRoom], y_[kRoom], distance2_[kRoom];  // of corners; what lies behind the last one is not looked at
    int size_ = 4;
    float reach2_ = 0;
};

}  // namespace dapple
