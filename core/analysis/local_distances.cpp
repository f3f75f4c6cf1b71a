#include "core/analysis/local_distances.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/analysis/distances.h"

namespace dapple {
namespace {

constexpr double kLowestDensity = 0.01;

}  // namespace

double dots_at_full_density(const Density& density, std::size_t count) {
    return double(count) / density.mean();
}

LocalDistances local_distances(std::span<const glm::dvec2> dots, const Density& density, double full) {
    const double longer = density.longer_side();
    const Domain page{density.width() / longer, density.height() / longer, Topology::window};
    const double spacing = std::sqrt(page.area() / double(dots.size()));
    const std::vector<double> nearest = nearest_distances(dots, page);
    std::vector<double> relative;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const glm::dvec2 p = dots[i];
        const double to_edge = std::min({p.x, p.y, page.width - p.x, page.height - p.y});
        const double at_dot = density.at(p);
        if (to_edge < spacing || at_dot < kLowestDensity) continue;
        relative.push_back(nearest[i] / std::sqrt(2 / (std::sqrt(3.0) * full * at_dot)));
    }
    LocalDistances result{.count = relative.size()};
    if (relative.empty()) return result;
    std::sort(relative.begin(), relative.end());
    const double place = 0.01 * double(relative.size() - 1);
    const auto below = std::size_t(place);
    const std::size_t above = std::min(below + 1, relative.size() - 1);
    result.p1 = std::lerp(relative[below], relative[above], place - double(below));
    for (const double distance : relative) result.mean += distance / double(relative.size());
    return result;
}

}  // namespace dapple
