#pragma once
// Steps of weighted Lloyd relaxation (Lloyd 1982; for stippling Secord 2002).
//
// Each dot goes towards the centroid of its Voronoi cell, some times the way: 1.8 times takes half as many
// steps as going just there, and short and long ones by turns fewer still. Weighted by density squared, so
// that the dots keep the density that they were placed with.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/image/density.h"
#include "core/relaxing/dot_rows.h"

namespace dapple {

// One dot's Voronoi cell: the part of a rectangle around it that is nearer to it than to any other dot. Or of
// a power diagram (Aurenhammer 1987), where larger dots have larger cells.

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

// Where the weight of a cell's ink balances.

/// Offset of a centroid from the dot, in the cell's unit.
struct Centroid {
    float x = 0, y = 0;
    bool has_ink = false;  // else the density is 0 all over the cell
};

/// A position on the picture from which small offsets are counted in single precision.
struct PixelAnchor {
    int column = 0, row = 0;  // the pixel whose centre lies before it
    float x = 0, y = 0;       // how far before it, 0..1
};

/// Integrates density squared over cells of one picture. A centroidal tessellation's dots have a density that
/// is the square root of its weight (Du, Faber & Gunzburger 1999, section 6.3), so squared the dots keep the
/// density that they were placed with. Beyond the picture the density goes on as it is at the edge.
class WeightedCentroid {
 public:
    /// Cells and positions are given in a unit of so many page units. The density has to live on.
    WeightedCentroid(const Density& density, double unit);

    PixelAnchor anchor(float x, float y) const;

    /// The density at an offset from there.
    float density_at(const PixelAnchor& anchor, float x, float y) const;

    /// A small cell, of a few pixels, by three points in each triangle between the dot and an edge (exact for
    /// quadratic functions); a larger one by lines a pixel apart and as many points along them. Both move
    /// with the cell, so that the centroid moves smoothly.
    Centroid of(const VoronoiCell& cell, const PixelAnchor& anchor);

 private:
    // The pixels above and below a line, and how far it lies between them.
    struct PixelLine {
        const float *upper, *lower;
        float share;
    };
    PixelLine line_at(const PixelAnchor& anchor, float y) const;
    Centroid by_triangles(const VoronoiCell& cell, const PixelAnchor& anchor, bool inside) const;
    Centroid by_lines(const VoronoiCell& cell, const PixelAnchor& anchor, float top, float bottom);
    void find_lines(const VoronoiCell& cell, float top, float bottom, int lines);

    const Grid<float>& values_;
    const double pixels_per_unit_;
    const float pixels_;
    std::vector<float> left_, right_;  // where the cell begins and ends on each line
};

/// The steps of a row's dots, one row after another. The rows and the density have to outlive it.
class LloydSteps {
 public:
    /// A cell reaches so many rows at most, so that a dot depends on its surroundings only. In light areas
    /// where dots are further apart (below a hundredth of black) cells are cut off at this distance.
    static constexpr float kCellReach = 8;
    /// Dots further away than twice a corner's distance are no neighbours.
    static constexpr int kFarthestRow = 23;
    static_assert(kFarthestRow > 2 * std::numbers::sqrt2 * kCellReach);

    LloydSteps(const DotRows& rows, const Density& density, const PageRows& page)
        : rows_(rows), page_(page), centroid_(density, std::ldexp(1.0, -page.depth)) {}

    void begin_row(std::int64_t row) {
        row_ = row;
        cursors_.begin(rows_, row);
    }

    /// The step of a dot of that row, `stride` times the way to its centroid, at most kCellReach long; each
    /// one asked for lies further to the right than the one before.
    DotStep step(std::size_t dot, float stride);

 private:
    // Dots of a row: those before `left` and from `right` on are still to be looked at.
    struct Stretch {
        std::size_t begin, end, left, right;
    };
    VoronoiCell cell_of(std::int64_t row, std::size_t dot, float density);
    Stretch stretch_around(std::int64_t row, float x);

    const DotRows& rows_;
    const PageRows page_;
    WeightedCentroid centroid_;
    std::int64_t row_ = 0;
    RowCursors<kFarthestRow> cursors_;
};

}  // namespace dapple
