#pragma once
// One dot's Voronoi cell: the part of a rectangle around it that is nearer to it than to any other dot. Or of
// a power diagram (Aurenhammer 1987), where larger dots have larger cells.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace dapple {

/// A convex polygon seen from its dot at (0, 0), its corners clockwise where y points down. Single precision:
/// which dots cut it, and in which order, decides about its last bits.
class VoronoiCell {
 public:
    struct Corner {
        float x, y;
        float distance2;  // from the dot, squared
    };

    /// A rectangle with the dot in it. No dot that cuts it is further `ahead`.
    VoronoiCell(float left, float top, float right, float bottom, float most_ahead = 0)
        : corners_{at(left, top), at(right, top), at(right, bottom), at(left, bottom)},
          most_ahead_(most_ahead) {
        find_reach();
    }

    int size() const { return size_; }
    const Corner& operator[](int i) const { return corners_[i]; }

    /// The square of the distance from which on other dots leave the cell as it is: twice the farthest
    /// corner's, where none is ahead.
    float reach2() const { return reach2_; }

    /// Cuts off what is nearer to another dot; not the same place. `ahead`: the square of the other's radius
    /// less that of the own one, by which the squares of the distances to both differ in a power diagram. It
    /// has bounds, so that no dot loses the place where it lies. One by one in plain numbers: vectors would
    /// wait for the corners that the last cut has just written.
    [[gnu::always_inline]] inline void cut(float other_x, float other_y, float ahead = 0) {
        // Beyond the bisector: x * other_x + y * other_y > half the square of the distance.
        const float distance2 = other_x * other_x + other_y * other_y, most = kMostAhead * distance2;
        const float half = 0.5f * (distance2 - std::min(std::max(ahead, -most), most));
        float beyond[kMost];
        std::uint32_t outside = 0;
        for (int i = 0; i < size_; ++i) {
            beyond[i] = corners_[i].x * other_x + corners_[i].y * other_y - half;
            outside |= std::uint32_t{beyond[i] > 0} << i;
        }
        if (outside != 0) cut_off(outside, beyond);
    }

 private:
    static constexpr int kMost = 24;           // corners
    static constexpr float kMostAhead = 0.7f;  // of the square of the distance between two dots

    static Corner at(float x, float y) { return {x, y, x * x + y * y}; }

    // Where the edge between a corner inside and one outside is cut.
    Corner between(int in, int out, const float* beyond) const {
        const float share = beyond[in] / (beyond[in] - beyond[out]);
        const Corner &a = corners_[in], &b = corners_[out];
        return at(a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share);
    }

    // The corners outside follow each other: two new ones come in their place.
    [[gnu::always_inline]] inline void cut_off(std::uint32_t outside, const float* beyond) {
        const std::uint32_t all = (1u << size_) - 1;
        if (outside == all) return;  // which rounding alone can bring about
        // The run outside: from `first` to before `end`, past the last corner where it wraps.
        const bool wraps = (outside & 1) != 0 && (outside >> (size_ - 1) & 1) != 0;
        const int first = wraps ? std::bit_width(~outside & all) : std::countr_zero(outside);
        const int end = wraps ? std::countr_zero(~outside) : std::bit_width(outside);
        const int run = wraps ? size_ - first + end : end - first;
        if (size_ - run + 2 > kMost) return;  // no dot has so many neighbours
        const Corner leaving = between(first == 0 ? size_ - 1 : first - 1, first, beyond);
        const Corner entering = between(end == size_ ? 0 : end, end == 0 ? size_ - 1 : end - 1, beyond);
        int place = first;
        if (wraps) {
            place = first - end;
            for (int i = 0; i < place; ++i) corners_[i] = corners_[i + end];
        } else if (run == 1) {
            for (int i = size_; i > end; --i) corners_[i] = corners_[i - 1];
        } else {
            for (int i = end; i < size_; ++i) corners_[i - run + 2] = corners_[i];
        }
        corners_[place] = leaving;
        corners_[place + 1] = entering;
        size_ += 2 - run;
        find_reach();
    }

    void find_reach() {
        float farthest2 = corners_[0].distance2;
        for (int i = 1; i < size_; ++i)
            farthest2 = corners_[i].distance2 > farthest2 ? corners_[i].distance2 : farthest2;
        reach2_ = 4 * farthest2;
        if (most_ahead_ > 0) {
            const float reach = std::sqrt(farthest2) + std::sqrt(farthest2 + most_ahead_);
            reach2_ = reach * reach;
        }
    }

    Corner corners_[kMost];
    int size_ = 4;
    float most_ahead_, reach2_ = 0;
};

}  // namespace dapple
