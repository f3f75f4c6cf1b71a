#include "core/lights/direction.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

using std::numbers::pi;

// What the map's centre, its quarter and its top are in space. centre x quarter is up, except in pbrt, whose
// maps run the other way round.
struct Frame {
    glm::dvec3 centre, quarter, up;
};

Frame frame_of(SphereConvention convention) {
    switch (convention) {
        case SphereConvention::openexr:
        case SphereConvention::usd:
        case SphereConvention::mitsuba:
            return {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
        case SphereConvention::blender:
            return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        case SphereConvention::pbrt:
            return {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    }
    return {};
}

}  // namespace

glm::dvec3 direction_of(glm::dvec2 uv, SphereConvention convention) {
    const Frame frame = frame_of(convention);
    const double around = 2 * pi * (0.5 - uv.x), theta = pi * uv.y;
    return portable::sin(theta) *
               (portable::cos(around) * frame.centre + portable::sin(around) * frame.quarter) +
           portable::cos(theta) * frame.up;
}

glm::dvec2 uv_of(glm::dvec3 direction, SphereConvention convention) {
    const Frame frame = frame_of(convention);
    const double forward = glm::dot(direction, frame.centre), sideways = glm::dot(direction, frame.quarter);
    double u = 0.5 - portable::atan2(sideways, forward) / (2 * pi);
    if (u >= 1) u -= 1;
    const double v =
        portable::atan2(std::sqrt(forward * forward + sideways * sideways), glm::dot(direction, frame.up)) /
        pi;
    return {std::max(u, 0.0), v};
}

glm::dvec3 turned_about_up(glm::dvec3 direction, double degrees, SphereConvention convention) {
    const glm::dvec3 up = frame_of(convention).up;
    const double angle = degrees * pi / 180;
    const glm::dvec3 along = glm::dot(direction, up) * up;
    return along + portable::cos(angle) * (direction - along) +
           portable::sin(angle) * glm::cross(up, direction);
}

}  // namespace dapple
