#pragma once
// The dots of all pens as one drawing: no two of any pens lie closer than a drawing with one pen has them,
// and each pen's own are even too.
//
//      dots as placed and relaxed ──► shared out along a Hilbert curve ──► pens exchanged between near dots
//                                                       ▲                            │
//                                                       └── dots moved for both ◄────┘   (a few times)
//
// Where pens have dots of several sizes, these are moved further once it is settled which dot is whose.
//
// Layers made one by one would collide wherever two pens draw; screens at angles make moire.

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/image/density.h"
#include "core/pens/pen_labels.h"

namespace dapple {

/// The densities by which a page's dots are shared out: each pen's, and their sum, which is that of all dots.
struct PenDensities {
    std::shared_ptr<const Density> all;
    std::vector<std::shared_ptr<const Density>> each;  // of each pen, as the palette

    /// The shares of the dots at a place, 1 together; alike for all where there are to be none.
    Shares shares_at(glm::dvec2 place) const;
};

struct PenDotsRequest {
    double scale = 0;  // that the dots were placed at
    bool move = true;  // else the dots stay where they are
    /// The area of a dot of each pen, in any unit; empty: all are as large. Larger ones then push smaller
    /// ones away until all of them cover as much paper as dots of one size would.
    std::vector<double> areas = {};
    int threads = 1;  // the result is the same for any number; 0: all cores
};

/// A piece for each pen, in the order of the palette; Dots::pen says which. Dots keep their other columns,
/// but for radii where there are areas. No pieces if stopped.
DotPieces pen_dots(const DotPieces& dots, const PenDensities& densities, const PenDotsRequest& request,
                   const std::stop_token& stop = {});

}  // namespace dapple
