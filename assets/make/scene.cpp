#include "assets/make/scene.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace dapple::make {
namespace {

using glm::dvec2;
using glm::dvec3;

// Rays start this far off, so that they don't meet the surface they leave.
constexpr double lift = 2e-4;

// How much of the table around (x, z) is not covered by the thread.
double bare(const Scene& scene, const dvec2& p) {
    for (const Arc& arc : scene.thread) {
        const dvec2 from_centre = p - arc.centre;
        if (std::abs(glm::length(from_centre) - arc.radius) > 0.5 * scene.thread_width) continue;
        const double turn = 2 * std::numbers::pi;
        double angle = std::atan2(from_centre.y, from_centre.x) - arc.from;
        angle -= turn * std::floor(angle / turn);
        if (angle <= arc.to - arc.from) return 0;
    }
    return 1;
}

// The normal tilted by the relief: its gradient along the surface is subtracted.
dvec3 tilted(const dvec3& normal, Texture texture, const dvec3& point) {
    constexpr double h = 5e-4;
    const double here = detail_at(texture, point).height;
    dvec3 gradient(0);
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 beside = point;
        beside[axis] += h;
        gradient[axis] = (detail_at(texture, beside).height - here) / h;
    }
    return glm::normalize(normal - (gradient - normal * glm::dot(gradient, normal)));
}

}  // namespace

glm::dmat3 axes_with_y(const dvec3& up) {
    const dvec3 y = glm::normalize(up);
    const dvec3 x = glm::normalize(glm::cross(y, std::abs(y.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0)));
    return {x, y, glm::cross(x, y)};
}

Stage::Stage(Scene scene) : scene_(std::move(scene)) {
    for (const Solid& solid : scene_.solids) {
        const Box box = bounds(solid.shape);
        const double radius = 0.5 * glm::length(box.high - box.low);
        around_.push_back({box, solid.position + solid.axes * (0.5 * (box.low + box.high)), radius * radius});
    }
}

bool Stage::may_hit(size_t solid, const Ray& ray, double length) const {
    const dvec3 to_centre = around_[solid].centre - ray.origin;
    const double along = glm::dot(to_centre, ray.direction), squared = glm::dot(to_centre, to_centre);
    const double r2 = around_[solid].squared_radius;
    if (squared - along * along > r2) return false;
    if (squared < r2) return true;
    return along > 0 && (along < length || squared - 2 * along * length + length * length < r2);
}

Ray Stage::in_frame(const Solid& solid, const Ray& ray) const {
    return {(ray.origin - solid.position) * solid.axes, ray.direction * solid.axes};
}

std::optional<Hit> Stage::hit(const Ray& ray) const {
    double nearest = std::numeric_limits<double>::infinity();
    const Solid* met = nullptr;
    for (size_t i = 0; i < scene_.solids.size(); ++i) {
        const Solid& solid = scene_.solids[i];
        if (!may_hit(i, ray, nearest)) continue;
        if (const auto t = first_hit(solid.shape, around_[i].box, in_frame(solid, ray), lift, nearest)) {
            nearest = *t;
            met = &solid;
        }
    }
    const double to_table = -ray.origin.y / ray.direction.y;
    if (to_table > lift && to_table < nearest) {
        const dvec3 point = ray.origin + to_table * ray.direction;
        Material table{.albedo = 0.76 * bare(scene_, {point.x, point.z})};
        return Hit{to_table, point + dvec3(0, lift, 0), dvec3(0, 1, 0), table, true};
    }
    if (!met) return std::nullopt;
    const Ray local = in_frame(*met, ray);
    const dvec3 point = local.origin + nearest * local.direction;
    const dvec3 normal = normal_at(met->shape, point);
    Material material = met->material;
    dvec3 bent = normal;
    if (material.texture != Texture::plain) {
        material.albedo *= detail_at(material.texture, point).tint;
        bent = tilted(normal, material.texture, point);
    }
    return Hit{nearest, ray.origin + nearest * ray.direction + lift * (met->axes * normal), met->axes * bent,
               material, false};
}

bool Stage::blocked(const Ray& ray, double length) const {
    for (size_t i = 0; i < scene_.solids.size(); ++i) {
        const Solid& solid = scene_.solids[i];
        if (may_hit(i, ray, length) &&
            first_hit(solid.shape, around_[i].box, in_frame(solid, ray), lift, length))
            return true;
    }
    return false;
}

}  // namespace dapple::make
