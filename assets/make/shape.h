#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

/// The solids of the still life, as signed distances in their own frame (y up). A distance is negative inside
/// and never larger than the true one, so that a ray may always step that far without passing a surface.
namespace dapple::make {

/// Centred at the origin.
struct Ball {
    double radius;
};

/// Centred at the origin; `half` includes the rounding of the edges.
struct Block {
    glm::dvec3 half;
    double rounding;
};

/// A torus around the y axis, centred at the origin.
struct Ring {
    double major, minor;
};

/// What a lathe makes: a closed polygon (distance from the axis, height) turned around the y axis, then
/// grown by `rounding`. Points are in order around the polygon; distances from the axis are not negative.
struct Turned {
    std::vector<glm::dvec2> profile;
    double rounding;
};

/// A straight round wire from the origin up the y axis.
struct Wire {
    double length, radius;
};

using Shape = std::variant<Ball, Block, Ring, Turned, Wire>;

struct Box {
    glm::dvec3 low, high;
};

struct Ray {
    glm::dvec3 origin, direction;  ///< direction of length 1
};

double distance_to(const Shape& shape, const glm::dvec3& point);

/// The smallest axis-parallel box around the shape.
Box bounds(const Shape& shape);

/// Where the ray first enters the shape, as a distance between `nearest` and `farthest`; nothing when it
/// misses.
std::optional<double> first_hit(const Shape& shape, const Box& box, const Ray& ray, double nearest,
                                double farthest);

/// Unit normal at a point of the surface, pointing outwards.
glm::dvec3 normal_at(const Shape& shape, const glm::dvec3& point);

}  // namespace dapple::make
