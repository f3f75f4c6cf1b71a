#pragma once
// How even a set of points is, and how periodic.

#include <cstddef>
#include <span>

#include "dapple/export.h"

namespace dapple {

enum class PointEdges {
    meet,     // opposite edges meet: the set repeats in both directions
    unknown,  // a cut-out: nothing is known beyond the edges
};

/// Free of the unit: distances are over the largest that so many points can all have, frequencies in units of
/// the root of the number of points over the area.
struct PointEvenness {
    std::size_t count = 0;
    double nearest_minimum = 0, nearest_first_percentile = 0, nearest_mean = 0;
    double power_below_03 = 0, power_below_05 = 0;  // mean power there; white noise has 1
    double highest_bin = 0;                         // of the spectrum
    double star_discrepancy = 0, l2_star_discrepancy = 0;
};

/// Points in a rectangle from 0 to width and 0 to height, x and y as many. 65,536 take some tenths of a
/// second. Throws std::runtime_error if one is not finite or lies outside a cut-out.
DAPPLE_API PointEvenness evenness_of(std::span<const double> x, std::span<const double> y, double width,
                                     double height, PointEdges edges = PointEdges::meet);

}  // namespace dapple
