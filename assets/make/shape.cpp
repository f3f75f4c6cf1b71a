#include "assets/make/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dapple::make {
namespace {

using glm::dvec2;
using glm::dvec3;

double distance(const Ball& ball, const dvec3& p) {
    return glm::length(p) - ball.radius;
}

double distance(const Block& block, const dvec3& p) {
    const dvec3 q = glm::abs(p) - (block.half - block.rounding);
    return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - block.rounding;
}

double distance(const Ring& ring, const dvec3& p) {
    return std::hypot(std::sqrt(p.x * p.x + p.z * p.z) - ring.major, p.y) - ring.minor;
}

double distance(const Turned& turned, const dvec3& point) {
    const dvec2 p(std::sqrt(point.x * point.x + point.z * point.z), point.y);
    double squared = std::numeric_limits<double>::max();
    bool inside = false;
    dvec2 a = turned.profile.back();
    for (const dvec2& b : turned.profile) {
        const dvec2 edge = b - a, to_p = p - a;
        const dvec2 off = to_p - edge * std::clamp(glm::dot(to_p, edge) / glm::dot(edge, edge), 0.0, 1.0);
        squared = std::min(squared, glm::dot(off, off));
        // Even-odd rule: count the edges that a line to the right of p crosses.
        if ((a.y > p.y) != (b.y > p.y) && (to_p.x * edge.y < to_p.y * edge.x) == (edge.y > 0))
            inside = !inside;
        a = b;
    }
    return (inside ? -1.0 : 1.0) * std::sqrt(squared) - turned.rounding;
}

double distance(const Wire& wire, const dvec3& p) {
    return glm::length(p - dvec3(0, std::clamp(p.y, 0.0, wire.length), 0)) - wire.radius;
}

Box box_of(const Ball& ball) {
    return {dvec3(-ball.radius), dvec3(ball.radius)};
}

Box box_of(const Block& block) {
    return {-block.half, block.half};
}

Box box_of(const Ring& ring) {
    const dvec3 half(ring.major + ring.minor, ring.minor, ring.major + ring.minor);
    return {-half, half};
}

Box box_of(const Turned& turned) {
    double radius = 0, low = turned.profile[0].y, high = low;
    for (const dvec2& p : turned.profile) {
        radius = std::max(radius, p.x);
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    const double r = turned.rounding;
    return {{-radius - r, low - r, -radius - r}, {radius + r, high + r, radius + r}};
}

Box box_of(const Wire& wire) {
    const double r = wire.radius;
    return {{-r, -r, -r}, {r, wire.length + r, r}};
}

// The solids are a few units large and seen by 1024 pixels: a hundredth of a pixel.
constexpr double close_enough = 3e-5;

}  // namespace

double distance_to(const Shape& shape, const dvec3& point) {
    return std::visit([&](const auto& s) { return distance(s, point); }, shape);
}

Box bounds(const Shape& shape) {
    return std::visit([](const auto& s) { return box_of(s); }, shape);
}

std::optional<double> first_hit(const Shape& shape, const Box& box, const Ray& ray, double nearest,
                                double farthest) {
    // Only the part of the ray inside the box is walked. A ray parallel to a side divides by zero on purpose:
    // the infinities compare rightly.
    const dvec3 t0 = (box.low - ray.origin) / ray.direction, t1 = (box.high - ray.origin) / ray.direction;
    const dvec3 enter = glm::min(t0, t1), leave = glm::max(t0, t1);
    double t = std::max({enter.x, enter.y, enter.z, nearest});
    const double end = std::min({leave.x, leave.y, leave.z, farthest});
    if (!(t < end)) return std::nullopt;
    return std::visit(
        [&](const auto& s) -> std::optional<double> {
            for (int step = 0; step < 200 && t < end; ++step) {
                const double d = distance(s, ray.origin + t * ray.direction);
                if (d < close_enough) return t;
                t += d;
            }
            return std::nullopt;
        },
        shape);
}

dvec3 normal_at(const Shape& shape, const dvec3& point) {
    // Four differences at the corners of a tetrahedron give the gradient.
    constexpr double h = 1e-5;
    dvec3 sum(0);
    for (const dvec3& corner : {dvec3(1, -1, -1), dvec3(-1, -1, 1), dvec3(-1, 1, -1), dvec3(1, 1, 1)})
        sum += corner * distance_to(shape, point + h * corner);
    return glm::normalize(sum);
}

}  // namespace dapple::make
