#pragma once
// Dots in rows of the page, each from the left to the right: how neighbours are found while dots move.
//
// What is found does not depend on how many dots lie elsewhere, and nothing is kept for bare paper: a page
// that is nearly white costs what its dots cost.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/density.h"
#include "core/maths/portable_math.h"
#include "core/placing/dots.h"

namespace dapple {

/// Rows of height 1, numbered from the page's upper edge. Which row a dot lies in, and which place it has
/// there, follow from positions alone.
class DotRows {
 public:
    using Positions = std::vector<float, UnsetAllocator<float>>;
    using Numbers = std::vector<std::uint32_t, UnsetAllocator<std::uint32_t>>;

    /// Takes dots, y from 0 up, in any order and numbers them as they come. At most 2^32 - 1. A row is
    /// 2^-depth page units high, so that positions are rescaled without rounding.
    void assign(const DotPieces& dots, int depth, int threads);

    /// Takes the same dots at other places: x and y of the dot that is the i-th now. Uses the two as memory.
    void move(Positions& to_x, Positions& to_y, int threads);

    std::size_t size() const { return x.size(); }
    std::int64_t rows() const { return static_cast<std::int64_t>(begins_.size()) - 1; }
    std::int64_t first_row() const { return first_row_; }  // the number on the page of row 0 here
    std::size_t begin(std::int64_t row) const { return begins_[static_cast<std::size_t>(row)]; }
    std::size_t end(std::int64_t row) const { return begins_[static_cast<std::size_t>(row) + 1]; }

    Positions x, y;    // in rows' heights; row after row, in each by x and then by y
    Positions areas;   // over the largest's, as whoever moves the dots tells them; empty: all are alike
    Positions radii2;  // rows' heights squared, told likewise
    float most_radius2 = 0;
    Numbers numbers;  // as they came

 private:
    void sort_into_rows(Positions& from_x, Positions& from_y, int threads);

    std::int64_t first_row_ = 0;
    std::vector<std::size_t> begins_{0};
    Numbers from_numbers_;
};

/// Places in the rows around one, which move on with its dots as these come from the left to the right.
template <int Farthest>
class RowCursors {
 public:
    /// All at their rows' beginnings.
    void begin(const DotRows& rows, std::int64_t row) {
        first_ = std::max<std::int64_t>(row - Farthest, 0);
        end_ = std::min<std::int64_t>(row + Farthest + 1, rows.rows());
        for (std::int64_t near = first_; near < end_; ++near) at(near) = rows.begin(near);
    }

    std::int64_t first() const { return first_; }
    std::int64_t end() const { return end_; }
    std::size_t& at(std::int64_t row) { return places_[static_cast<std::size_t>(row - first_)]; }

 private:
    std::int64_t first_ = 0, end_ = 0;
    std::array<std::size_t, 2 * Farthest + 1> places_{};
};

// The page in the rows that dots are relaxed in: their height is the unit.

struct PageRows {
    int depth;            // a row is 2^-depth page units high, about as dots on black are apart
    float width, height;  // of the page
    float spacing;        // of dots on black, 0.7 to 1.5; up to a million where there are hardly any
    double pixels;        // of the density, a row's height
    double page_units;    // a row's height

    PageRows(const Density& density, double scale)
        : depth(depth_for(scale)),
          width(rows(density.width(), density)),
          height(rows(density.height(), density)),
          spacing(
              static_cast<float>(std::min(std::ldexp(1.0, depth) / std::sqrt(kDotsPerScale * scale), kMost))),
          pixels(std::ldexp(static_cast<double>(density.longer_side()), -depth)),
          page_units(std::ldexp(1.0, -depth)) {}

    /// On the page, of a place in rows.
    glm::dvec2 place(float x, float y) const { return {x * page_units, y * page_units}; }

    static int depth_for(double scale) {
        return std::max(
            0, static_cast<int>(std::lround(portable::log2(kDotsPerScale * std::max(scale, 1e-12)) / 2)));
    }

 private:
    static constexpr double kMost = 1e6;

    float rows(int length, const Density& density) const {
        return static_cast<float>(std::ldexp(length / static_cast<double>(density.longer_side()), depth));
    }
};

/// How a dot is to move, in rows.
struct DotStep {
    float x = 0, y = 0;
};

// Where relaxing ends along a page's edges.

// Relaxed dots lean on where what they share out ends. On the edges themselves, dots would line up along
// them, and in black they would lie half a distance inwards and leave bare paper between the discs. So it
// ends in waves of two lengths that hardly ever meet again, which makes a page look cut out of a larger one:
// farther in, waves would leave bare bites, and farther out draw dots off the page. In black it ends a little
// beyond.
inline constexpr float kBeyondInBlack = 0.2f, kLightest = 0.85f,
                       kBlackest = 0.98f;  // densities, between which both are mixed
inline constexpr float kLeastBeyond = -0.4f, kMostBeyond = 0.35f;
inline constexpr float kWaveLengths[] = {3.7f, 5.9f};
static_assert(kLeastBeyond < kBeyondInBlack && kBeyondInBlack < kMostBeyond);

// Waves, in distances between dots.
struct EdgeWaves {
    float beyond;  // the edge, their middle
    float height;  // of each
};
inline constexpr EdgeWaves kWavesOfCells{0.05f, 0.45f};
// Lower ones keep more of the tone along the edges, and are enough for dots that go down an energy.
inline constexpr EdgeWaves kWavesOfDensity{0.09f, 0.36f};

// A triangle wave, -1..1, of length 1, from 0 up. A sine's last bit would not be the same everywhere.
inline float triangle_wave(float t) {
    return 1 - 4 * std::abs(t - 0.25f - std::floor(t + 0.25f));
}

/// How far beyond the edge, in distances between dots, by where along the edge, in distances from its middle:
/// a picture on its side has the same dots. kLeastBeyond..kMostBeyond.
inline float beyond_edge(EdgeWaves waves, float from_middle, float density) {
    const float t = std::abs(from_middle);
    const float light = std::clamp((kBlackest - density) / (kBlackest - kLightest), 0.0f, 1.0f);
    const float wave = triangle_wave(t / kWaveLengths[0]) + triangle_wave(t / kWaveLengths[1]);
    const float waving = std::clamp(waves.beyond + waves.height * wave, kLeastBeyond, kMostBeyond);
    return kBeyondInBlack + light * (waving - kBeyondInBlack);
}

}  // namespace dapple
