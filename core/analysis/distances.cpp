#include "core/analysis/distances.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <limits>
#include <numeric>

namespace dapple {

PointGrid::PointGrid(std::span<const glm::dvec2> points, const Domain& domain) : domain_(domain) {
    const double side = std::sqrt(2 * domain.area() / double(std::max<std::size_t>(points.size(), 1)));
    // A domain much longer than wide gets no more than 2^24 cells.
    columns_ = std::clamp(long(domain.width / side), 1L, 4096L);
    rows_ = std::clamp(long(domain.height / side), 1L, 4096L);
    cell_ = {domain.width / double(columns_), domain.height / double(rows_)};

    std::vector<std::uint32_t> cell_of(points.size());
    start_.assign(std::size_t(columns_ * rows_) + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const long column = std::clamp(long(std::floor(points[i].x / cell_.x)), 0L, columns_ - 1);
        const long row = std::clamp(long(std::floor(points[i].y / cell_.y)), 0L, rows_ - 1);
        cell_of[i] = std::uint32_t(row * columns_ + column);
        ++start_[cell_of[i] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(points.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        sorted_[next[cell_of[i]]++] = {points[i], std::uint32_t(i)};
}

LocalDensity local_density(std::span<const glm::dvec2> points, const Domain& domain, double points_per_cell) {
    LocalDensity result;
    if (points.empty()) return result;
    const double n = double(points.size());
    const double side = std::sqrt(domain.area() * points_per_cell / n);
    result.columns = int(std::clamp(std::round(domain.width / side), 1.0, 1024.0));
    result.rows = int(std::clamp(std::round(domain.height / side), 1.0, 1024.0));
    result.relative.resize(std::size_t(result.columns) * std::size_t(result.rows));

    const double cells = double(result.relative.size());
    for (const glm::dvec2 p : points) {
        const int column = std::min(int(p.x / domain.width * result.columns), result.columns - 1);
        const int row = std::min(int(p.y / domain.height * result.rows), result.rows - 1);
        result.relative[std::size_t(row) * std::size_t(result.columns) + std::size_t(column)] += 1;
    }
    double squares = 0;
    for (double& density : result.relative) {
        density *= cells / n;
        squares += (density - 1) * (density - 1);
    }
    const auto [lowest, highest] = std::minmax_element(result.relative.begin(), result.relative.end());
    result.lowest = *lowest;
    result.highest = *highest;
    result.deviation = std::sqrt(squares / cells);
    return result;
}

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
