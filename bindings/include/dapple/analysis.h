#pragma once
// How even a set of points is, and how periodic.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// The power spectrum as `dapple-lab analyse` draws it, row after row from the top: waves of up to two a mean
/// distance of points to all sides, slow ones in the middle; black is 0, white noise a dark grey, and what
/// chance does not make, as a repetition, orange.
struct SpectrumPicture {
    int width = 0, height = 0;      // about alike
    std::vector<std::uint8_t> rgb;  // sRGB-encoded
};

/// Throws as evenness_of() does.
DAPPLE_API SpectrumPicture spectrum_of(std::span<const double> x, std::span<const double> y, double width,
                                       double height, PointEdges edges = PointEdges::meet);

/// The share of points that meet another one when all are moved by that period, or some of it, freed of
/// chance: 1 if the set repeats itself, about 0 for unrelated points. Throws as evenness_of() does, and if
/// the period is not above 0.
DAPPLE_API double periodicity_of(std::span<const double> x, std::span<const double> y, double width,
                                 double height, double period, PointEdges edges = PointEdges::meet);

}  // namespace dapple
