#include "dapple/analysis.h"

#include <fmt/format.h>

#include <glm/vec2.hpp>
#include <stdexcept>
#include <vector>

#include "core/analysis/report.h"

namespace dapple {

PointEvenness evenness_of(std::span<const double> x, std::span<const double> y, double width, double height,
                          PointEdges edges) {
    if (x.size() != y.size())
        throw std::runtime_error(fmt::format("{} values of x and {} of y", x.size(), y.size()));
    std::vector<glm::dvec2> points;
    points.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
    const Topology topology = edges == PointEdges::meet ? Topology::torus : Topology::window;
    const PointReport report = *analyse(points, {width, height, topology});
    return {.count = report.count,
            .nearest_minimum = report.nearest.minimum,
            .nearest_first_percentile = report.nearest.p1,
            .nearest_mean = report.nearest.mean,
            .power_below_03 = report.power_below_03,
            .power_below_05 = report.power_below_05,
            .highest_bin = report.peaks.highest_bin,
            .star_discrepancy = report.star_discrepancy.upper,
            .l2_star_discrepancy = report.l2_star_discrepancy};
}

}  // namespace dapple
