#pragma once
// What the Voronoi cells of a drawing's dots are like, weighed by the density that was to be drawn.

#include "core/image/density.h"
#include "lab/related/wanted.h"

namespace dapple {

/// All 0 for no dots.
struct CellMarks {
    /// The energy that centroidal tessellations have least of (Du, Faber & Gunzburger 1999): the mean square
    /// of the distance to the nearest dot, over a dot's share of the page. Of constant density a hexagonal
    /// lattice has 5 / (18 sqrt(3)) = 0.160, a square one 1/6.
    double energy = 0;
    /// Of the cells' weights, the standard deviation over the mean (Balzer, Schloemer & Deussen 2009).
    double capacity = 0;
    /// From a dot to its cell's centroid, the mean over the root of a dot's share of the page.
    double displacement = 0;
};

CellMarks cell_marks(const PlainDots& dots, const Density& density);

}  // namespace dapple
