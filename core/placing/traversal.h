#pragma once
// The recursion over the squares of the page that the placer and the view of its tiles share.
//
//      visit(square): all dots in the square, if they are in its cell's subtree; else
//                     the square's own dots
//                     visit(those of its quadrants in which scale * max density reaches a newborn point)
//
// Everything that decides about a dot depends on its square's address, the density and the scale alone, never
// on the window or on threads: every window of a drawing shows the same dots.

#include <array>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <optional>

#include "core/image/density.h"
#include "core/image/rectangle.h"
#include "core/placing/placer.h"
#include "core/placing/placing_table.h"

namespace dapple {

/// Squares are not divided beyond this depth: their addresses are 62-bit integers.
inline constexpr int kMaxDepth = 60;

/// A square of the recursion.
struct Visit {
    QuadSquare square;
    std::uint16_t cell = 0;   // which part of its tile; above the depth of the cells the digits so far
    Orientation orientation;  // of its tile
    bool in_window = false;   // wholly; else tested dot by dot
    SmallSquare density;      // of a large square only the bounds
};

/// What depends on a square's depth alone.
struct DepthScale {
    double half = 0;         // half the side, page units
    double side_pixels = 0;  // side, in pixels of the density
    // Where the density begins and ends, in such squares, with parts of some.
    double first_column = 0, first_row = 0, columns_end = 0, rows_end = 0;
    double ranks_per_density = 0;  // scale * 16 / 4^(level of the tile that the square is a cell of)
    float threshold_per_rank = 0;  // 4^level / 16
};

class Traversal {
 public:
    /// Dots that do not exist at `tail_scale`, or hardly, are the tail; see SquareEmitter.
    Traversal(const PlacingTable& table, const Density& density, const PlacingRequest& request,
              std::optional<double> tail_scale = {});

    const PlacingTable& table() const { return table_; }
    const Density& density() const { return density_; }
    const PlacingRequest& request() const { return request_; }
    const DepthScale& at_depth(int depth) const { return depths_[depth]; }
    /// The tail scale as a share of the scale; nothing: there is no tail.
    std::optional<double> tail_share() const { return tail_share_; }

    /// Goes to one of the four root squares, numbered as quadrants are. False if it holds no dot, or lies
    /// outside the window or the picture; `root` is then unspecified.
    bool start(int number, Visit& root) const;

    /// Whether the window holds the whole page.
    bool has_whole_page() const;

    /// Whether the recursion ends at the square: its quadrants hold no dots but those that points_of() has.
    bool ends_at(const Visit& visit) const;

    /// The points that the square itself brings: nothing above the root tile's cells; there the tile's own
    /// and the newborn ones; then the newborn ones, or the whole subtree where the recursion ends.
    const CellPoints& points_of(const Visit& visit, bool ends) const;

    /// Goes to a quadrant, numbered in the page's frame. False if no dot of its level or below can be there,
    /// or it lies outside the window; `child` is then unspecified.
    bool descend(const Visit& parent, int page_quadrant, Visit& child) const;

    /// The level of the tile that the square is a cell of; negative above the root tile's cells.
    int level(const Visit& visit) const { return visit.square.depth - table_.cell_depth; }

    /// In 2^-62 page units from the page's corner.
    Rectangle<std::int64_t> area_of(const QuadSquare& square) const;

    /// A square's corner from where positions are counted, the window's or the page's corner, in page units.
    glm::dvec2 corner_in_window(const QuadSquare& square) const;

    /// The request's window in 2^-62 page units, from `low` to below `high`.
    const Rectangle<std::int64_t>& window() const { return window_; }

 private:
    const PlacingTable& table_;
    const Density& density_;
    PlacingRequest request_;
    std::optional<double> tail_share_;
    Rectangle<std::int64_t> window_;
    glm::i64vec2 origin_{0}, tile_corner_{0};  // in the same units
    std::array<DepthScale, kMaxDepth + 1> depths_;
};

}  // namespace dapple
