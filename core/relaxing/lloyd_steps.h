#pragma once
// Steps of weighted Lloyd relaxation (Lloyd 1982; for stippling Secord 2002).
//
// Each dot goes towards the centroid of its Voronoi cell, some times the way: 1.8 times takes half as many
// steps as going just there, and short and long ones by turns fewer still. Weighted by density squared, so
// that the dots keep the density that they were placed with.

#include <cstddef>
#include <cstdint>
#include <numbers>

#include "core/image/density.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/page_rows.h"
#include "core/relaxing/voronoi_cell.h"
#include "core/relaxing/weighted_centroid.h"

namespace dapple {

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
