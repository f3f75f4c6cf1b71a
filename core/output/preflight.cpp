#include "core/output/preflight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "core/analysis/distances.h"
#include "core/routing/near_dots.h"

namespace dapple {
namespace {

std::uint64_t overlapping_unequal(const Dots& dots) {
    const std::vector<std::uint32_t> near = near_dots(dots.x, dots.y);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const auto first = near.begin() + static_cast<long>(i * kNearDots);
        count += std::any_of(first, first + static_cast<long>(kNearDots), [&](std::uint32_t k) {
            const double across = double(dots.x[i]) - dots.x[k], down = double(dots.y[i]) - dots.y[k];
            return k != i && std::hypot(across, down) < double(dots.radius[i]) + dots.radius[k];
        });
    }
    return count;
}

}  // namespace

namespace {

constexpr double kRounding = 1e-3;  // mm

}  // namespace

Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins) {
    const glm::dvec2 size(page.width_mm, page.height_mm);
    std::vector<glm::dvec2> places(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        // Rounded to float, one can lie a hair beyond the page.
        places[i] = glm::clamp(glm::dvec2(dots.x[i], dots.y[i]) * page.mm_per_page_unit, glm::dvec2(0), size);
    }
    Preflight result{.nearest_mm = std::numeric_limits<double>::infinity()};
    for (std::size_t i = 1; i < places.size(); ++i)
        result.pen_up_m += glm::distance(places[i - 1], places[i]) / 1000;
    for (const glm::dvec2 p : places) {
        const double inside = std::min({p.x, p.y, size.x - p.x, size.y - p.y});
        result.over_edge += inside < dot_radius_mm;
    }
    const Rectangle<double> area = within_margins.value_or(Rectangle<double>{{0, 0}, size});
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec2 p = places[i];
        const double radius = dots.radius.empty() ? dot_radius_mm : dots.radius[i] * page.mm_per_page_unit;
        const double inside =
            std::min({p.x - area.low.x, p.y - area.low.y, area.high.x - p.x, area.high.y - p.y});
        result.outside_margins += inside < radius - kRounding;
    }
    const Domain domain{size.x, size.y, Topology::window};
    for (const double distance : nearest_distances(places, domain)) {
        result.nearest_mm = std::min(result.nearest_mm, distance);
        if (dots.radius.empty()) result.overlapping += distance < 2 * dot_radius_mm;
        result.nearer_than_saxi += distance < kSaxiJoins;
        result.nearer_than_axidraw += distance < kAxiDrawJoins;
    }
    double radii_mm = static_cast<double>(dots.size()) * dot_radius_mm;
    if (!dots.radius.empty()) {
        result.overlapping = overlapping_unequal(dots);
        radii_mm = 0;
        for (const float radius : dots.radius) radii_mm += radius * page.mm_per_page_unit;
    }
    result.rings_m = 2 * std::numbers::pi * radii_mm / 1000;
    return result;
}

}  // namespace dapple
