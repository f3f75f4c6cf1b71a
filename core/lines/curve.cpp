#include "core/lines/curve.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace dapple {

void simplify(std::vector<glm::dvec2>& points, std::vector<float>& widths, double tolerance) {
    const auto distance = [](glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
        const glm::dvec2 along = b - a;
        const double square = glm::dot(along, along);
        const double t = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0;
        return glm::distance(point, a + t * along);
    };
    std::vector<char> stays(points.size(), 0);
    stays.front() = stays.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double most = tolerance;
        std::size_t worst = from;
        for (std::size_t k = from + 1; k < to; ++k) {
            const double missed = distance(points[k], points[from], points[to]);
            if (missed > most) {
                most = missed;
                worst = k;
            }
        }
        if (worst == from) continue;
        stays[worst] = 1;
        open.push_back({from, worst});
        open.push_back({worst, to});
    }
    std::size_t n = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!stays[k]) continue;
        points[n] = points[k];
        if (!widths.empty()) widths[n] = widths[k];
        ++n;
    }
    points.resize(n);
    if (!widths.empty()) widths.resize(n);
}

std::vector<Cubic> smooth_curve(std::span<const glm::dvec2> points) {
    constexpr double kCorner = 0.5;  // cosine of a turn
    const std::size_t last = points.size() - 1;
    const bool closed = last > 2 && points.front() == points.back();
    // The direction at a point, into and out of which segments lead: that of the parabola through it and its
    // neighbours. At a corner and at an end, that of the segment.
    const auto direction = [&](std::size_t at, bool out) {
        const bool end = (at == 0 || at == last) && !closed;
        const glm::dvec2 before = points[at] - points[at > 0 ? at - 1 : closed ? last - 1 : 0];
        const glm::dvec2 after = points[at < last ? at + 1 : closed ? 1 : last] - points[at];
        const double a = glm::length(before), b = glm::length(after);
        if (end || glm::dot(before, after) < kCorner * a * b) return out ? after / b : before / a;
        return glm::normalize(before * (b / a) + after * (a / b));
    };
    std::vector<Cubic> curves;
    for (std::size_t i = 0; i < last; ++i) {
        const double reach = glm::distance(points[i], points[i + 1]) / 3;
        curves.push_back({points[i], points[i] + reach * direction(i, true),
                          points[i + 1] - reach * direction(i + 1, false), points[i + 1]});
    }
    return curves;
}

}  // namespace dapple
