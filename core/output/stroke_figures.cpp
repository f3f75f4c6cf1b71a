#include "core/output/stroke_figures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "core/strokes/dot_shape.h"

namespace dapple {
namespace {

// From one speed to another, both of which can be reached: faster in between, as far as there is room.
double time_between(double mm, double from, double to, double top, double acceleration) {
    const double peak = std::min(top, std::sqrt((2 * acceleration * mm + from * from + to * to) / 2));
    const double gaining = (peak * peak - from * from) / (2 * acceleration),
                 losing = (peak * peak - to * to) / (2 * acceleration);
    return (peak - from) / acceleration + (peak - to) / acceleration +
           std::max(mm - gaining - losing, 0.0) / peak;
}

}  // namespace

double drawing_time(std::span<const glm::dvec2> points, const MachineSpeeds& speeds) {
    const double top = speeds.drawing_speed, acceleration = speeds.drawing_acceleration;
    std::vector<glm::dvec2> ways;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i] != points[i - 1]) ways.push_back(points[i] - points[i - 1]);
    // At the begin of each way, and 0 at the end of all.
    std::vector<double> speed(ways.size() + 1, 0.0);
    for (std::size_t i = 1; i < ways.size(); ++i) {
        const double turn = glm::dot(glm::normalize(ways[i - 1]), glm::normalize(ways[i]));
        const double reached =
            std::sqrt(speed[i - 1] * speed[i - 1] + 2 * acceleration * glm::length(ways[i - 1]));
        speed[i] = std::min(top * std::clamp(turn, 0.0, 1.0), reached);
    }
    double seconds = 0;
    for (std::size_t i = ways.size(); i-- > 0;) {
        const double mm = glm::length(ways[i]);
        speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + 2 * acceleration * mm));
        seconds += time_between(mm, speed[i], speed[i + 1], top, acceleration);
    }
    return seconds;
}

StrokeFigures figures_of(const StrokeStream& strokes, const MachineSpeeds& speeds) {
    StrokeFigures result;
    std::optional<glm::dvec2> last;
    strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int) {
        ++result.strokes;
        result.time.lifting_s += speeds.lower_s + speeds.raise_s;
        if (points.size() == 1)
            result.time.dots_s += speeds.dot_s;
        else
            result.time.drawing_s += drawing_time(points, speeds);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double way = glm::distance(points[i - 1], points[i]);
            result.drawn_m += way / 1000;
            result.longest_mm = std::max(result.longest_mm, way);
        }
        if (last) {
            const double way = glm::distance(*last, points[0]);
            result.pen_up_m += way / 1000;
            result.time.moving_s += move_time(way, speeds);
        }
        last = points.back();
    });
    return result;
}

PlottingTime plotting_time_of_rings(const Dots& dots, double mm_per_page_unit, double dot_radius_mm,
                                    const MachineSpeeds& speeds) {
    PlottingTime time = plotting_time(dots, mm_per_page_unit, speeds);
    time.dots_s = 0;
    const auto once_round = [&](double radius_mm) {
        return drawing_time(mark_of({DotShape::ring, {}}, radius_mm, 0).points, speeds);
    };
    if (dots.radius.empty()) {
        time.drawing_s = static_cast<double>(dots.size()) * once_round(dot_radius_mm);
    } else {
        for (const float radius : dots.radius) time.drawing_s += once_round(radius * mm_per_page_unit);
    }
    return time;
}

}  // namespace dapple
