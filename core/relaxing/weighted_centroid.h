#pragma once
// Where the weight of a cell's ink balances.

#include <vector>

#include "core/image/density.h"
#include "core/relaxing/voronoi_cell.h"

namespace dapple {

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

}  // namespace dapple
