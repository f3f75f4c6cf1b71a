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

constexpr double kRounding = 1e-3;  // mm

double least_inside(const Rectangle<double>& area, glm::dvec2 p) {
    return std::min({p.x - area.low.x, p.y - area.low.y, area.high.x - p.x, area.high.y - p.y});
}

}  // namespace

Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins, glm::dvec2 corner_mm,
                    const std::optional<Rectangle<double>>& paper) {
    std::vector<glm::dvec2> places(dots.size());
    glm::dvec2 low(0), high(page.width_mm, page.height_mm);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        places[i] = glm::dvec2(dots.x[i], dots.y[i]) * page.mm_per_page_unit + corner_mm;
        low = glm::min(low, places[i]);
        high = glm::max(high, places[i]);
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Preflight result{.nearest_mm = kNone, .first_percentile_mm = kNone};
    for (std::size_t i = 1; i < places.size(); ++i)
        result.pen_up_m += glm::distance(places[i - 1], places[i]) / 1000;
    const Rectangle<double> whole =
                                paper.value_or(Rectangle<double>{{0, 0}, {page.width_mm, page.height_mm}}),
                            within = within_margins.value_or(whole);
    double radii_mm = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double radius = dots.radius.empty() ? dot_radius_mm : dots.radius[i] * page.mm_per_page_unit;
        result.over_edge += least_inside(whole, places[i]) < radius - kRounding;
        result.outside_margins += least_inside(within, places[i]) < radius - kRounding;
        radii_mm += radius;
    }
    // Dots reach in from beyond a part, and one can lie a hair beyond a page.
    for (glm::dvec2& place : places) place -= low;
    const Domain domain{high.x - low.x, high.y - low.y, Topology::window};
    std::vector<double> nearest = nearest_distances(places, domain);
    for (const double distance : nearest) {
        result.nearest_mm = std::min(result.nearest_mm, distance);
        if (dots.radius.empty()) result.overlapping += distance < 2 * dot_radius_mm;
        result.nearer_than_saxi += distance < kSaxiJoins;
        result.nearer_than_axidraw += distance < kAxiDrawJoins;
    }
    if (nearest.size() > 1) {
        const auto first_percentile = nearest.begin() + static_cast<long>(nearest.size() / 100);
        std::nth_element(nearest.begin(), first_percentile, nearest.end());
        result.first_percentile_mm = *first_percentile;
    }
    if (!dots.radius.empty()) result.overlapping = overlapping_unequal(dots);
    result.rings_m = 2 * std::numbers::pi * radii_mm / 1000;
    return result;
}

double InkedDot::reach_mm(double own_radius_mm, int pen) const {
    const auto i = static_cast<std::size_t>(pen);
    const double half = (i < widths_mm.size() ? widths_mm[i] : stroke_width_mm) / 2;
    switch (as) {
        case DotsAs::touches:
        case DotsAs::lines:
            return half;
        case DotsAs::shapes:
            return std::max(own_radius_mm, half);
        case DotsAs::printed:
        case DotsAs::rings:
        case DotsAs::listed:
            break;
    }
    return own_radius_mm;
}

Dots inked_dots(const DotStream& dots, const InkedDot& inked, const PageSize& page) {
    const double unit = page.mm_per_page_unit, usual = inked.reach_mm(inked.radius_mm, 0);
    Dots all;
    all.reserve(dots.count, false);
    bool alike = true;
    std::vector<float> reaches;
    dots.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double own = piece.radius.empty() ? inked.radius_mm : piece.radius[i] * unit;
            const double reach = inked.reach_mm(own, piece.pen);
            all.x.push_back(piece.x[i]);
            all.y.push_back(piece.y[i]);
            reaches.push_back(static_cast<float>(reach / unit));
            // Radii are kept as floats.
            alike = alike && std::abs(reach - usual) < 1e-6 * usual;
        }
        return true;
    });
    if (!alike) all.radius.assign(reaches.begin(), reaches.end());
    return all;
}

}  // namespace dapple
