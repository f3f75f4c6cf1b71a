#pragma once
// Discrepancy: how far the share of points in a box [0, x) x [0, y) is from its area, over all boxes that
// start in the domain's lower corner. Domains are scaled to the unit square, and edges don't meet.

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>

#include "core/analysis/domain.h"

namespace dapple {

/// L2 star discrepancy, the root of the mean square over all boxes, by Warnock's formula (1972)
///      1/9 - 2/n sum (1 - x^2)(1 - y^2) / 4 + 1/n^2 sum sum (1 - max(x, x'))(1 - max(y, y')),
/// the double sum in O(n log n) by a sweep over x (the two-dimensional case of Heinrich 1996). Accurate to
/// about 1e-8. White noise of n points has sqrt(5 / (36 n)) in the mean square. 0 for no points.
double l2_star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain);

/// The star discrepancy, the greatest deviation over all boxes, lies within [lower, upper].
struct StarDiscrepancy {
    double lower = 0;
    double upper = 0;
};

/// Exact (lower = upper) for up to `exact_up_to` points: a sweep over x that keeps the counts of all y in
/// blocks with their convex hulls, O(n sqrt(n)), about 0.1 s for 65,536 points. For more points a bracket
/// from a grid of 1024 x 1024 boxes (Thiémard 2001): what a box between two corners of the grid can hold is
/// between what those hold; it is at most about 2/1024 wide. {0, 0} for no points. Unfinished when a stop was
/// requested.
StarDiscrepancy star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain,
                                 std::size_t exact_up_to = 131072, std::stop_token stop = {});

}  // namespace dapple
