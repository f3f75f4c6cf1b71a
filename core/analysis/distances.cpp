#include "core/analysis/distances.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/point_grid.h"

namespace dapple {
namespace {

double nearest_distance(const PointGrid& grid, const PointGrid::Entry& point) {
    const Domain& domain = grid.domain();
    const double diagonal = std::hypot(domain.width, domain.height);
    // Evenly spread points have their nearest within the first radius, a little more than their spacing.
    for (double radius = 0.75 * grid.cell_size();; radius *= 2) {
        double best = std::numeric_limits<double>::infinity();
        grid.for_each_around(point.position, radius, [&](const PointGrid::Entry& other, glm::dvec2 offset) {
            const double squared = offset.x * offset.x + offset.y * offset.y;
            if (squared == 0 && &other == &point) return;  // the point itself, not an image of it
            best = std::min(best, squared);
        });
        if (best <= radius * radius) return std::sqrt(best);
        if (domain.topology == Topology::window && radius > diagonal) return std::sqrt(best);
    }
}

}  // namespace

std::vector<double> nearest_distances(std::span<const glm::dvec2> points, const Domain& domain,
                                      std::stop_token stop) {
    std::vector<double> distances(points.size());
    const PointGrid grid(points, domain);
    const std::span<const PointGrid::Entry> entries = grid.entries();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, entries.size(), 1024), [&](const auto& range) {
        if (stop.stop_requested()) return;
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            distances[entries[i].index] = nearest_distance(grid, entries[i]);
    });
    return distances;
}

NearestSummary nearest_summary(std::span<const glm::dvec2> points, const Domain& domain,
                               std::stop_token stop) {
    std::vector<double> distances = nearest_distances(points, domain, stop);
    if (distances.empty() || std::isinf(distances.front())) return {};
    std::sort(distances.begin(), distances.end());
    const double place = 0.01 * double(distances.size() - 1);
    const std::size_t below = std::size_t(place);
    const std::size_t above = std::min(below + 1, distances.size() - 1);
    double sum = 0;
    for (double d : distances) sum += d;
    const double spacing = 2 * largest_radius(domain, distances.size());
    return {.minimum = distances.front() / spacing,
            .p1 = std::lerp(distances[below], distances[above], place - double(below)) / spacing,
            .mean = sum / double(distances.size()) / spacing};
}

}  // namespace dapple
