#pragma once
// Steps of weighted Lloyd relaxation (Lloyd 1982; for stippling Secord 2002).
//
// Each dot goes towards the centroid of its Voronoi cell, some times the way: 1.8 times takes half as many
// steps as going just there, and short and long ones by turns fewer still. Weighted by density squared, so
// that the dots keep the density that they were placed with.

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/image/density.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/voronoi_cell.h"

namespace dapple {

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
