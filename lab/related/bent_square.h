#pragma once
// The unit square bent into a picture: even points become points of its density.

#include <vector>

#include "lab/related/wanted.h"

namespace dapple {

/// Inverts the cumulative density, first of the rows, then within the row (Pharr, Jakob & Humphreys,
/// "Physically Based Rendering", 2-D piecewise constant distributions). Pixels count as flat, so what comes
/// out differs from the bilinear density by less than a pixel's width.
class BentSquare {
 public:
    /// None: the unit square as it is. Throws std::runtime_error if the density is 0 everywhere.
    explicit BentSquare(const Density* density);

    /// From [0, 1) x [0, 1) to the page.
    glm::dvec2 operator()(glm::dvec2 even) const;

 private:
    int width_ = 0, height_ = 0, longer_ = 1;
    std::vector<double> rows_;     // cumulative, one more than there are
    std::vector<double> columns_;  // the same within each row
};

}  // namespace dapple
