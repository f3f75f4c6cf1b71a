#include "core/output/preflight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "core/analysis/distances.h"

namespace dapple {

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
        result.nearer_than_saxi += distance < kSaxiJoins;
        result.nearer_than_axidraw += distance < kAxiDrawJoins;
    }
    return result;
}

}  // namespace dapple
