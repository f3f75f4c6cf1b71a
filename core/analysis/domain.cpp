#include "core/analysis/domain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/failure.h"

namespace dapple {
namespace {

double wrapped(double x, double period) {
    const double inside = x - period * std::floor(x / period);
    return inside < period ? inside : 0;  // a tiny negative x rounds up to the period itself
}

}  // namespace

double largest_radius(const Domain& domain, std::size_t count) {
    return std::sqrt(domain.area() / (2 * std::sqrt(3.0) * double(count)));
}

std::vector<glm::dvec2> points_inside(std::span<const glm::dvec2> points, const Domain& domain,
                                      const std::string& name) {
    if (!(domain.width > 0 && domain.height > 0 && std::isfinite(domain.area())))
        throw failure("{}: a domain of {} x {} has no area; give two positive sides", name, domain.width,
                      domain.height);
    std::vector<glm::dvec2> inside(points.begin(), points.end());
    for (std::size_t i = 0; i < inside.size(); ++i) {
        glm::dvec2& p = inside[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            throw failure("{}: point {} is at ({}, {}); every coordinate must be a finite number", name,
                          i + 1, p.x, p.y);
        if (domain.topology == Topology::torus) {
            p = {wrapped(p.x, domain.width), wrapped(p.y, domain.height)};
        } else if (p.x < 0 || p.y < 0 || p.x > domain.width || p.y > domain.height) {
            throw failure("{}: point {} at ({}, {}) lies outside the {} x {} window; give a larger window",
                          name, i + 1, p.x, p.y, domain.width, domain.height);
        }
    }
    return inside;
}

void drop_duplicates(std::vector<glm::dvec2>& points, double near) {
    std::ranges::sort(points,
                      [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<glm::dvec2> kept;
    for (const glm::dvec2 p : points) {
        bool seen = false;
        for (auto at = kept.rbegin(); at != kept.rend() && p.x - at->x <= near && !seen; ++at)
            seen = std::abs(p.y - at->y) <= near;
        if (!seen) kept.push_back(p);
    }
    points = std::move(kept);
}

}  // namespace dapple
