#pragma once
// One smooth displacement of all dots, for what is wrong over several of them.
//
// A step moves a dot by what is around it, and what is too dark or too light over many dots stays so. A warp
// compares what all dots come to with what they should, both blurred by a mean spacing, and lets the excess r
// flow off: where laplace(phi) = r, and rho is what there should be, the displacement u = grad(phi) / rho has
// div(rho u) = r. It is optimal transport's to the first order (Villani 2003, "Topics in Optimal
// Transportation", section 4.1.2): dots that lie near each other move alike, and stay as even as they were.
//
// Dots of a picture are compared by the light that they leave, drawn as large as its tone asks for; others as
// they are counted, by area where these differ.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "core/image/density.h"
#include "core/image/detail.h"
#include "core/image/grid.h"
#include "core/image/ink.h"
#include "core/relaxing/dot_rows.h"

namespace dapple {

// Which parts of a page discs cover, in bits: exact where they overlap, and in any order.

/// So many cells across and down, each of kSide x kSide bits.
class CoveredBits {
 public:
    static constexpr int kSide = 8;

    CoveredBits(int cells_across, int cells_down)
        : cells_(cells_across),
          words_(static_cast<std::size_t>((cells_across * kSide + 63) / 64)),
          height_(cells_down * kSide),
          bits_(words_ * static_cast<std::size_t>(height_)) {}

    /// The bits whose middles lie within an ellipse, which may reach beyond. All in bits' sides.
    void cover(glm::vec2 middle, glm::vec2 radius) {
        const int width = cells_ * kSide;
        const int top = std::max(up(middle.y - radius.y - 0.5f), 0);
        const int bottom = std::min(down_to(middle.y + radius.y - 0.5f), height_ - 1);
        for (int y = top; y <= bottom; ++y) {
            const float down = (static_cast<float>(y) + 0.5f - middle.y) / radius.y;
            const float half = radius.x * std::sqrt(std::max(1 - down * down, 0.0f));
            const int first = std::max(up(middle.x - half - 0.5f), 0);
            const int last = std::min(down_to(middle.x + half - 0.5f), width - 1);
            if (first > last) continue;
            std::uint64_t* const row = bits_.data() + static_cast<std::size_t>(y) * words_;
            const int begin = first / 64, end = last / 64;
            const std::uint64_t from = kAll << first % 64, to = kAll >> (63 - last % 64);
            if (begin == end) {
                row[begin] |= from & to;
                continue;
            }
            row[begin] |= from;
            std::fill(row + begin + 1, row + end, kAll);
            row[end] |= to;
        }
    }

    /// The share of each cell of a row that is bare.
    void bare(int row_of_cells, float* to) const {
        for (std::size_t word = 0; word < words_; ++word) {
            std::uint64_t sums = 0;  // of set bits, a byte for each cell
            for (int k = 0; k < kSide; ++k) {
                std::uint64_t v = bits_[static_cast<std::size_t>(row_of_cells * kSide + k) * words_ + word];
                v -= v >> 1 & 0x5555555555555555;
                v = (v & 0x3333333333333333) + (v >> 2 & 0x3333333333333333);
                sums += (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0f;
            }
            const int first = static_cast<int>(word) * (64 / kSide);
            for (int i = 0; i < std::min(64 / kSide, cells_ - first); ++i)
                to[first + i] = 1 - static_cast<float>(sums >> kSide * i & 0xff) / (kSide * kSide);
        }
    }

 private:
    // Whole numbers not below, and not above; std::ceil() and std::floor() would be calls.
    static int up(float value) {
        const int whole = static_cast<int>(value);
        return whole + (static_cast<float>(whole) < value);
    }
    static int down_to(float value) { return -up(-value); }

    static constexpr std::uint64_t kAll = ~std::uint64_t{0};

    int cells_;
    std::size_t words_;  // a row's
    int height_;
    std::vector<std::uint64_t> bits_;
};

// Poisson's equation on a page's cells.

/// Calls body(row) for each row of cells, some of them at a time on a thread.
template <class Body>
void for_each_row(int rows, const Body& body) {
    constexpr int kAtOnce = 16;
    tbb::parallel_for(0, (rows + kAtOnce - 1) / kAtOnce, [&](int stretch) {
        for (int y = stretch * kAtOnce; y < std::min((stretch + 1) * kAtOnce, rows); ++y) body(y);
    });
}

/// About so many cells along a length, a number that can be halved often: of cells that are about 1 long.
int cells_along(double length);

/// phi with laplace(phi) = excess, through whose edges nothing flows: by cycles of multigrid (Brandt 1977).
/// Cells have that size, and the excess sums to 0 or nearly. The same bits for any number of threads.
Grid<float> poisson(Grid<float> excess, glm::vec2 cell, int cycles = 2);

/// How far what lies at a place is carried, in rows' heights; see PageRows.
class Displacement {
 public:
    /// Nothing anywhere.
    Displacement() = default;
    /// Through the left and right sides of cells of that size, and through the upper and lower ones: a column
    /// and a row more than there are cells.
    Displacement(Grid<float> across, Grid<float> down, glm::vec2 cell)
        : across_(std::move(across)), down_(std::move(down)), cell_(cell) {}

    glm::vec2 at(float x, float y) const;

 private:
    Grid<float> across_, down_;
    glm::vec2 cell_{1};
};

/// No dot is carried farther, in rows' heights.
inline constexpr float kFarthestWarped = 4;

/// What is to be known of the dots to be warped.
struct WarpRequest {
    double scale = 0;  // that they were placed at
    double dots = 0;   // so many, about
    DotAreas areas = {};
    std::shared_ptr<const InkCurve> ink = {};  // from density to light; none: they are counted
    /// The page ends at the picture's edges, which cut dots off: what is lost of them is made up for. Else
    /// dots that lie within a mean spacing of an edge stay more and more as they are.
    bool cut_off = false;
};

/// What a page's dots are warped towards, in cells of which three lie side by side in a mean spacing, and at
/// most some 2048 along a side.
class Warp {
 public:
    Warp(const Density& density, const WarpRequest& request);

    /// Of dots in rows, with their areas if these differ.
    Displacement displacement(const DotRows& dots) const;

    /// The same of dots that come one by one and are counted. The warp has to outlive it.
    class Count {
     public:
        explicit Count(const Warp& warp);
        /// At a place in rows' heights; of such an area over the largest's.
        void add(float x, float y, float area = 1);
        Displacement displacement() const;

     private:
        const Warp& warp_;
        std::vector<std::uint32_t> sums_;
    };

 private:
    Grid<float> wanted(const Density& density, const DotAreas& areas) const;
    Grid<float> light_of(const DotRows& dots) const;
    void take_loads(Grid<float>& light) const;
    Displacement displacement_for(Grid<float> present) const;

    PageRows page_;
    std::shared_ptr<const InkCurve> ink_;
    std::vector<float> loads_;  // that leave so much light, at equal steps of it
    int width_ = 0, height_ = 0;
    glm::vec2 cell_{1};  // rows' heights
    float spacing_ = 1;  // likewise, of dots on the mean
    float radius_ = 0;   // likewise, of the largest
    bool cut_off_ = false;
    Grid<float> wanted_;  // load in each cell, or dots
    Grid<float> most_;    // that one warp takes off, of the first
};

}  // namespace dapple
