#pragma once
// Nearest-neighbour distances of a point set.
//
// Distances are given over the spacing of the hexagonal lattice of the same count, 2 r_max with
// r_max = sqrt(area / (2 sqrt(3) n)): the hexagonal lattice has 1, the square lattice sqrt(sqrt(3) / 2) =
// 0.9306. The smallest of them is the relative radius (Lagae & Dutré 2006, section 5; "A Comparison of
// Methods for Generating Poisson Disk Distributions", 2008, section 4), half the smallest distance over
// r_max. White noise has a mean of 1 / (2 sqrt(density)), 0.4653 here.

#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

/// For every point the distance to its nearest neighbour, in the unit of the domain. On a torus the point's
/// own images count, so one point alone is a square lattice. In a window a point near the edge has neighbours
/// on one side only, and a lone point has infinity. A million evenly spread points take a fraction of a
/// second; a set that is crowded into a small part of its domain takes longer. Points as points_inside()
/// gives them. Unfinished (zeros) when a stop was requested.
std::vector<double> nearest_distances(std::span<const glm::dvec2> points, const Domain& domain,
                                      std::stop_token stop = {});

/// All over 2 r_max; all 0 if no point has a neighbour.
struct NearestSummary {
    double minimum = 0;  // the relative radius of the set
    double p1 = 0;       // 1st percentile: sorted value at place (n - 1) / 100, interpolated between two
    double mean = 0;
};

NearestSummary nearest_summary(std::span<const glm::dvec2> points, const Domain& domain,
                               std::stop_token stop = {});

}  // namespace dapple
