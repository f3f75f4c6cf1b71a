#pragma once
// A density over the page, with bounds over every square of a quadtree so that a recursion can be exact.
//
// Page frame: x to the right, y down, the picture's longer side is 1. The quadtree's root squares have the
// same side. One has its corner on the picture's own, unless the density says where else it lies: then four
// of them reach over the picture. Squares hold nothing outside the picture. A picture's density is bilinear
// between the pixels' centres and constant beyond the outermost; one may also be constant in each pixel.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// The square of side 2^-depth whose corner is (x, y) * 2^-depth from the density's tile_corner(): of depth 0
/// the four with x and y of -1 and 0 reach over the picture.
struct QuadSquare {
    int depth = 0;
    std::int64_t x = 0, y = 0;
};

struct Bounds {
    float min = 0, max = 0;
};

/// The density within a square that lies between four pixels' centres: d = c + x X + y Y + xy X Y, with X and
/// Y from the square's centre in half sides, -1..1.
struct BilinearPatch {
    double c = 0, x = 0, y = 0, xy = 0;

    /// The same density in the square's quadrant q.
    BilinearPatch quadrant(int q) const;

    /// Its extremes are at the square's corners. Widened by what evaluating it in single precision can err.
    Bounds bounds() const;
};

/// Pixels from the first to the last column and row, these included. They may lie outside the picture.
struct PixelRange {
    std::int64_t first_column = 0, last_column = 0, first_row = 0, last_row = 0;
};

/// A square of a few pixels or less.
struct SmallSquare {
    Bounds bounds;
    bool is_patch = false;  // lies between four pixels' centres, or in one cell, within the picture
    BilinearPatch patch;    // if so
    PixelRange pixels;      // else: those that interpolation can touch
};

/// What lies to the left and right of the picture.
enum class Sides {
    paper,  // nothing: bare paper
    wrap,   // the picture's other side: interpolation goes round, as on an environment map
};

/// What a pixel's value holds for.
enum class Reading {
    bilinear,  // its centre
    by_cell,   // all of the pixel
};

class Density {
 public:
    /// Values 0..1 (more is allowed, as on environment maps). Throws std::runtime_error if the grid is empty
    /// or a value is negative or not finite.
    explicit Density(Grid<float> values, Sides sides = Sides::paper, glm::dvec2 tile_corner = {0, 0},
                     Reading reading = Reading::bilinear);

    int width() const { return values_.width; }
    int height() const { return values_.height; }
    int longer_side() const { return longer_; }
    Sides sides() const { return sides_; }
    Reading reading() const { return reading_; }
    /// Where in a pixel, from its edge, its value begins to give way to the next one's, if it does so at all.
    double middle() const { return reading_ == Reading::bilinear ? 0.5 : 0; }
    /// Where on the page root squares begin: from 0 to below 1, in whole 2^-20.
    glm::dvec2 tile_corner() const { return tile_corner_; }
    /// The same in pixels.
    glm::dvec2 corner_pixel() const { return tile_corner_ * static_cast<double>(longer_); }
    const Grid<float>& values() const { return values_; }

    /// Mean over a square of the longer side, the empty part included.
    double mean() const { return mean_; }

    /// The density at a point of the page; 0 outside the picture.
    double at(glm::dvec2 p) const;

    /// Numbers that no value in the square lies below and above. Exact up to rounding (and safe against it)
    /// on squares smaller than a pixel; on larger ones the bounds of the pixels that interpolation there can
    /// touch.
    Bounds bounds(const QuadSquare& square) const {
        if (square.depth >= static_cast<int>(pyramid_.size())) return look(square).bounds;
        return pyramid_[square.depth].bounds(square.x, square.y);
    }

    /// Squares of this depth and more are small: a few pixels and less.
    int small_depth() const { return static_cast<int>(pyramid_.size()); }

    /// All there is to know about a small square, at once.
    SmallSquare look(const QuadSquare& square) const;

    /// The pixels that interpolation in a square can touch.
    PixelRange pixels_in(const QuadSquare& square) const;

    /// A pixel's value; outside the picture that of the nearest or, across a wrapping seam, of the other
    /// side.
    float pixel(std::int64_t column, std::int64_t row) const;

 private:
    struct Level {
        std::int64_t left = 0, top = 0, width = 0, height = 0;
        std::vector<Bounds> squares;

        Bounds bounds(std::int64_t x, std::int64_t y) const {
            const std::int64_t column = x - left, row = y - top;
            const bool outside = column < 0 || row < 0 || column >= width || row >= height;
            return outside ? Bounds{} : squares[static_cast<std::size_t>(row * width + column)];
        }
    };

    // The pixels, first and last, that reading between two positions in pixels from the edge can touch.
    std::pair<std::int64_t, std::int64_t> support(double from, double to) const;
    void build_pyramid();

    Grid<float> values_;
    Sides sides_;
    Reading reading_;
    glm::dvec2 tile_corner_;
    int longer_ = 0;
    double mean_ = 0;
    std::array<double, 64> side_{};  // of a square, in pixels, by depth
    std::vector<Level> pyramid_;     // by depth; the last has squares of two to four pixels
};

/// Dots on a unit area where the density is 1, at scale 1: those of the paper's tile.
inline constexpr double kDotsPerScale = 16;

/// How many dots there are at a scale, about.
inline double expected_dots(const Density& density, double scale) {
    return kDotsPerScale * scale * density.mean();
}

/// The scale at which so many dots are expected; finite on white too.
inline double scale_for(const Density& density, double dots) {
    return dots / (kDotsPerScale * std::max(density.mean(), 1e-9));
}

}  // namespace dapple
