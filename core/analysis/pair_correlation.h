#pragma once
// How many points lie at each distance from a point, over how many there would be in white noise.

#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

/// Distances are in units of the mean spacing sqrt(area / n).
struct PairCorrelationOptions {
    double highest_distance = 5;
    double bin_width = 0.05;
};

struct PairCorrelation {
    double bin_width = 0.05;
    std::vector<double> g;  // bin b is for distances of b to b + 1 bin widths; 1 = white noise
};

/// The pair correlation g(r) of a point set (Illian et al. 2008, "Statistical Analysis and Modelling of
/// Spatial Point Patterns", chapter 4): ordered pairs of different points at the distances of a bin, over n
/// (n - 1) / area times the area of the bin's ring. On a torus all images of the other points count. In a
/// window a pair (dx, dy) weighs area / ((width - |dx|) (height - |dy|)), which makes good for the partners
/// beyond the edge (Ohser's translation correction); distances beyond the window get 0.
/// All 0 for fewer than two points. Points as points_inside() gives them. The same to the bit for any number
/// of threads. Unfinished when a stop was requested.
PairCorrelation pair_correlation(std::span<const glm::dvec2> points, const Domain& domain,
                                 const PairCorrelationOptions& options = {}, std::stop_token stop = {});

}  // namespace dapple
