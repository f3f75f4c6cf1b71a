#include "dapple/analysis.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <stdexcept>
#include <vector>

#include "core/analysis/report.h"
#include "core/analysis/spectrum.h"

namespace dapple {
namespace {

struct Points {
    std::vector<glm::dvec2> points;
    Domain domain;
};

Points points_of(std::span<const double> x, std::span<const double> y, double width, double height,
                 PointEdges edges) {
    if (x.size() != y.size())
        throw std::runtime_error(fmt::format("{} values of x and {} of y", x.size(), y.size()));
    std::vector<glm::dvec2> points;
    points.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
    const Domain domain{width, height, edges == PointEdges::meet ? Topology::torus : Topology::window};
    return {points_inside(points, domain), domain};
}

}  // namespace

PointEvenness evenness_of(std::span<const double> x, std::span<const double> y, double width, double height,
                          PointEdges edges) {
    const auto [points, domain] = points_of(x, y, width, height, edges);
    const PointReport report = *analyse(points, domain);
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

SpectrumPicture spectrum_of(std::span<const double> x, std::span<const double> y, double width, double height,
                            PointEdges edges) {
    const auto [points, domain] = points_of(x, y, width, height, edges);
    const Grid<glm::u8vec3> picture = spectrum_picture(periodogram(points, domain));
    SpectrumPicture result{picture.width, picture.height, {}};
    result.rgb.reserve(3 * picture.values.size());
    for (const glm::u8vec3& pixel : picture.values)
        result.rgb.insert(result.rgb.end(), {pixel.r, pixel.g, pixel.b});
    return result;
}

double periodicity_of(std::span<const double> x, std::span<const double> y, double width, double height,
                      double period, PointEdges edges) {
    if (!(period > 0) || !std::isfinite(period))
        throw std::runtime_error(fmt::format("a period of {} cannot repeat; give a positive length", period));
    const auto [points, domain] = points_of(x, y, width, height, edges);
    return periodicity(points, domain, glm::dvec2(period)).value;
}

}  // namespace dapple
