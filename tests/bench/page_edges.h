#pragma once
// How dots lie along a page's edges, where relaxing by straight cells would rule a frame.

#include <array>

#include "tests/bench/relaxed_dots.h"

namespace dapple {

struct PageEdges {
    /// Dots in bands a quarter of the distance between dots wide, as it is there, from the edge on: over how
    /// many the density asks for.
    std::array<double, 6> bands{};
    /// The highest peak of the spectrum of dots in strips two distances wide, between 0.1 and 2.9 waves a
    /// distance: along the edges, and along strips inside. Dots at random have 1 in the mean.
    double peak = 0, peak_inside = 0;
};

PageEdges page_edges(const RelaxedDots& drawn);

}  // namespace dapple
