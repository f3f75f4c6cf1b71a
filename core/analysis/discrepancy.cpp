#include "core/analysis/discrepancy.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/analysis/raised_counts.h"

namespace dapple {
namespace {

// The points in the unit square, by ascending x.
std::vector<glm::dvec2> unit_points_by_x(std::span<const glm::dvec2> points, const Domain& domain) {
    std::vector<glm::dvec2> unit(points.begin(), points.end());
    for (glm::dvec2& p : unit) p /= glm::dvec2(domain.width, domain.height);
    std::sort(unit.begin(), unit.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return unit;
}

std::vector<double> distinct_y(const std::vector<glm::dvec2>& points) {
    std::vector<double> y;
    for (const glm::dvec2 p : points) y.push_back(p.y);
    std::sort(y.begin(), y.end());
    y.erase(std::unique(y.begin(), y.end()), y.end());
    return y;
}

std::size_t place_of(const std::vector<double>& sorted, double value) {
    return std::size_t(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

// The greatest excess of points in closed boxes [0, x] x [0, y]: corners at the points' own x and y.
double greatest_excess(const std::vector<glm::dvec2>& by_x, const std::vector<double>& y,
                       std::stop_token stop) {
    const double n = double(by_x.size());
    RaisedCounts counts(y, +1);
    double greatest = 0;
    double possible = 0;  // a bound for the excess here: each point adds 1 at most
    for (std::size_t i = 0; i < by_x.size() && !stop.stop_requested();) {
        const double x = by_x[i].x;
        for (; i < by_x.size() && by_x[i].x == x; ++i) {
            counts.raise_from(place_of(y, by_x[i].y));
            possible += 1;
        }
        if (possible <= greatest) continue;
        possible = counts.greatest(n * x);
        greatest = std::max(greatest, possible);
    }
    return greatest / n;
}

// The greatest lack of points in open boxes [0, x) x [0, y): corners at the points' own x and y, and at 1.
double greatest_lack(const std::vector<glm::dvec2>& by_x, std::vector<double> y, std::stop_token stop) {
    const double n = double(by_x.size());
    if (y.back() < 1) y.push_back(1);
    RaisedCounts counts(y, -1);
    double greatest = 0;
    double last_x = 0, last_lack = 0;  // since then the lack has grown by n (x - last_x) at most
    const auto ask_at = [&](double x) {
        if (last_lack + n * (x - last_x) <= greatest) return;
        last_x = x;
        last_lack = counts.greatest(n * x);
        greatest = std::max(greatest, last_lack);
    };
    for (std::size_t i = 0; i < by_x.size() && !stop.stop_requested();) {
        const double x = by_x[i].x;
        ask_at(x);
        for (; i < by_x.size() && by_x[i].x == x; ++i) counts.raise_from(place_of(y, by_x[i].y) + 1);
    }
    if (by_x.back().x < 1) ask_at(1);
    return greatest / n;
}

StarDiscrepancy bracket(const std::vector<glm::dvec2>& points) {
    constexpr std::size_t kSide = 1024;
    constexpr std::size_t kStride = kSide + 1;
    // Points below and left of each corner of the grid; points on the upper edges count with the last cells.
    std::vector<double> share(kStride * kStride);
    for (const glm::dvec2 p : points) {
        const std::size_t x = std::min(kSide - 1, std::size_t(p.x * kSide));
        const std::size_t y = std::min(kSide - 1, std::size_t(p.y * kSide));
        share[(y + 1) * kStride + x + 1] += 1;
    }
    for (std::size_t y = 1; y <= kSide; ++y)
        for (std::size_t x = 1; x <= kSide; ++x)
            share[y * kStride + x] +=
                share[(y - 1) * kStride + x] + share[y * kStride + x - 1] - share[(y - 1) * kStride + x - 1];
    const double n = double(points.size());
    const auto area = [](std::size_t x, std::size_t y) { return double(x * y) / double(kSide * kSide); };
    StarDiscrepancy result;
    for (std::size_t y = 1; y <= kSide; ++y)
        for (std::size_t x = 1; x <= kSide; ++x) {
            const double outer = share[y * kStride + x] / n;
            const double inner = share[(y - 1) * kStride + x - 1] / n;
            // The corner (1, 1) holds all points whatever their place on the edge.
            result.lower = std::max(result.lower, std::abs(outer - area(x, y)));
            result.upper = std::max({result.upper, outer - area(x - 1, y - 1), area(x, y) - inner});
        }
    return result;
}

}  // namespace

double l2_star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain) {
    if (points.empty()) return 0;
    const std::vector<glm::dvec2> by_x = unit_points_by_x(points, domain);
    const std::vector<double> y = distinct_y(by_x);
    const double n = double(by_x.size());

    // For each point those before it, of smaller or equal x: sum of 1 - max(y, y'), from two Fenwick trees
    // over the places of y.
    std::vector<double> number(y.size() + 1), height(y.size() + 1);  // of the points; of 1 - y
    double all_heights = 0;
    double single = 0, pairs = 0;
    for (const glm::dvec2 p : by_x) {
        const std::size_t place = place_of(y, p.y) + 1;
        double below = 0, heights_below = 0;
        for (std::size_t k = place; k > 0; k &= k - 1) {
            below += number[k];
            heights_below += height[k];
        }
        const double before = below * (1 - p.y) + (all_heights - heights_below);
        single += (1 - p.x * p.x) * (1 - p.y * p.y);
        pairs += (1 - p.x) * (2 * before + (1 - p.y));
        for (std::size_t k = place; k <= y.size(); k += k & (~k + 1)) {
            number[k] += 1;
            height[k] += 1 - p.y;
        }
        all_heights += 1 - p.y;
    }
    return std::sqrt(std::max(0.0, 1.0 / 9 - single / (2 * n) + pairs / (n * n)));
}

StarDiscrepancy star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain,
                                 std::size_t exact_up_to, std::stop_token stop) {
    if (points.empty()) return {};
    const std::vector<glm::dvec2> by_x = unit_points_by_x(points, domain);
    if (by_x.size() > exact_up_to) return bracket(by_x);
    const std::vector<double> y = distinct_y(by_x);
    double excess = 0, lack = 0;
    tbb::parallel_invoke([&] { excess = greatest_excess(by_x, y, stop); },
                         [&] { lack = greatest_lack(by_x, y, stop); });
    return {std::max(excess, lack), std::max(excess, lack)};
}

}  // namespace dapple
