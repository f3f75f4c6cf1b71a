#pragma once
// The analysis of a point set as a page, for people.

#include <string>

#include "core/analysis/report.h"
#include "lab/analysis/subject.h"

namespace dapple {

/// A page that needs nothing beside it: the points, their spectrum, curves and figures, each with a sentence
/// that says how to read it and what white noise and lattices have.
std::string report_page(const Subject& subject, const PointReport& report);

/// The same pieces for other pages. A PNG of a grid, and one of points as black dots, `longer_side` pixels
/// wide or high; `part` of them only, from the upper left corner of a square of that share of the longer
/// side.
std::string png_of(const Grid<glm::u8vec3>& picture);
std::string png_of_points(const std::vector<glm::dvec2>& points, const Domain& domain, int longer_side,
                          double part = 1);
std::string radial_power_plot(const PointReport& report);
std::string anisotropy_plot(const PointReport& report);
std::string pair_correlation_plot(const PointReport& report);

}  // namespace dapple
