#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "assets/make/shape.h"
#include "assets/make/texture.h"

/// Solids standing on a table (the plane y = 0) before a backdrop, a lamp and a camera. x right, y up,
/// z towards the viewer.
namespace dapple::make {

struct Material {
    double albedo = 0.7;
    double gloss = 0;      ///< share of light mirrored at normal incidence
    double roughness = 0;  ///< spread of the mirrored rays
    Texture texture = Texture::plain;
};

struct Solid {
    Shape shape;
    Material material;
    glm::dvec3 position{0};  ///< of the shape's own origin
    glm::dmat3 axes{1};      ///< columns: the shape's own axes
};

/// A rectangle that shines evenly on the side of its normal.
struct Lamp {
    glm::dvec3 centre, half_right, half_up, normal;
    double irradiance;  ///< on a surface at the origin that faces it
};

struct Camera {
    glm::dvec3 eye, target;
    double half_angle;  ///< radians, from the middle of the picture to the middle of an edge
};

/// A line on the table: an arc around `centre` (x, z), from angle `from` to `to` (radians, increasing).
struct Arc {
    glm::dvec2 centre;
    double radius, from, to;
};

struct Scene {
    std::vector<Solid> solids;
    std::vector<Arc> thread;  ///< lies on the table
    double thread_width = 0;
    Lamp lamp{};
    Camera camera{};
};

struct Hit {
    double distance;
    glm::dvec3 point, normal;
    Material material;  ///< albedo with its texture applied
    bool on_table;
};

/// A scene ready for many rays: each solid with the box and ball around it.
class Stage {
 public:
    explicit Stage(Scene scene);

    const Scene& scene() const { return scene_; }
    /// The first surface, solid or table, that the ray meets.
    std::optional<Hit> hit(const Ray& ray) const;
    /// Whether a solid is in the way within `length`.
    bool blocked(const Ray& ray, double length) const;

 private:
    struct Around {
        Box box;
        glm::dvec3 centre;
        double squared_radius;
    };
    bool may_hit(size_t solid, const Ray& ray, double length) const;
    Ray in_frame(const Solid& solid, const Ray& ray) const;

    Scene scene_;
    std::vector<Around> around_;
};

/// Axes with y along `up` (not zero), the other two anywhere across.
glm::dmat3 axes_with_y(const glm::dvec3& up);

}  // namespace dapple::make
