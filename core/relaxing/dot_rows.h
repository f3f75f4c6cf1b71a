#pragma once
// Dots in rows of the page, each from the left to the right: how neighbours are found while dots move.
//
// What is found does not depend on how many dots lie elsewhere, and nothing is kept for bare paper: a page
// that is nearly white costs what its dots cost.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace dapple
