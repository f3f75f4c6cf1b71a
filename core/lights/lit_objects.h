#pragma once
// White things in the light of a map or of its samples, by which to see what a renderer makes of them: a
// diffuse sphere, a glossy one, and ground in the shadow of a sphere.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/image/environment.h"
#include "core/image/grid.h"

namespace dapple {

// An environment map with its samples drawn over it: the paper's figure 7.

/// The factor on radiance with which a map's typical light is mid-grey: 0.18 over the geometric mean of the
/// luminance of the texels that have light, weighted by solid angle.
double natural_exposure(const EnvironmentMap& map);

/// sRGB-encoded. Light is exposed, then pressed together, L / (1 + L), so that lamps keep their colour.
glm::u8vec3 tone_mapped(const glm::dvec3& radiance, double exposure);

/// The map, each texel a square of so many pixels that the picture is at least 2,048 wide, and a white disc
/// with a dark rim at each place (u, v), so many pixels in radius.
Grid<glm::u8vec3> light_picture(const EnvironmentMap& map, std::span<const glm::dvec2> places,
                                double exposure, double disc_radius = 2);

// What lights do to a diffuse surface: the integral of radiance times cosine over the hemisphere of a normal.
// Or to a glossy one, which has a power of the cosine (Phong 1975).

/// A light that is far away: a unit vector towards it, and the irradiance on a surface that faces it.
struct DistantLight {
    glm::dvec3 direction{};
    glm::dvec3 weight{};
};

/// Every texel of the map as a light at its centre, weight = radiance * solid angle, directions as in
/// OpenEXR; black ones left out.
std::vector<DistantLight> texel_lights(const EnvironmentMap& map);

/// A light with all that texels from `low` up to `high` have, from its centre of gravity; that has no
/// direction if they are black.
DistantLight block_light(const EnvironmentMap& map, glm::ivec2 low, glm::ivec2 high);

/// Such a light for each block of so many texels a side, black ones left out: for
/// maps whose texels are far finer than anything that a surface shows of them.
std::vector<DistantLight> block_lights(const EnvironmentMap& map, int texels_a_side);

/// Sum of weight * max(0, direction . normal)^exponent, for each normal (unit vectors). The exponent is 1 or
/// more. The result does not depend on the number of cores.
std::vector<glm::dvec3> irradiance(std::span<const DistantLight> lights, std::span<const glm::dvec3> normals,
                                   unsigned exponent = 1);

/// Over normals, of |E - exact| / exact, E and exact being the luminance of what a surface gets by some
/// lights and by all of a map's. Normals with no light at all are left out.
struct RelativeError {
    double mean = 0, largest = 0;
};
/// `weights`, one a normal, count in the mean; none: all alike.
RelativeError relative_error(std::span<const glm::dvec3> found, std::span<const glm::dvec3> exact,
                             std::span<const double> weights = {});

/// The exponent of the glossy surface that samples are measured by.
inline constexpr unsigned kGlossy = 50;

/// Evenly spread unit vectors: the golden angle around, equal steps in height (Swinbank & Purser 2006).
std::vector<glm::dvec3> fibonacci_normals(int count);

/// Sum of weight * cosine^exponent about every direction, on a latitude-longitude grid of so many rows and
/// twice as many columns, directions as in OpenEXR.
class IrradianceMap {
 public:
    explicit IrradianceMap(std::span<const DistantLight> lights, unsigned exponent = 1, int rows = 24);

    /// Bilinear.
    glm::dvec3 at(glm::dvec3 normal) const;

    const Grid<glm::dvec3>& values() const { return values_; }

 private:
    Grid<glm::dvec3> values_;
};

/// Over the sphere's directions.
RelativeError difference(const IrradianceMap& found, const IrradianceMap& exact);

/// The irradiance of level ground on which a sphere of radius 1 stands, in whose shadow some of it lies.
class ShadedGround {
 public:
    static constexpr double kRadius = 2.6;  // of the piece that is known

    explicit ShadedGround(std::span<const DistantLight> lights);

    /// Bilinear, x and z from where the sphere stands.
    glm::dvec3 at(glm::dvec2 place) const;

 private:
    Grid<glm::dvec3> values_;
};

struct LitObjects {
    explicit LitObjects(std::span<const DistantLight> lights);

    IrradianceMap diffuse, glossy, from_above;  // from_above: without the light from below the horizon
    ShadedGround ground;
};

enum class LitObject { diffuse, glossy, shaded };
inline constexpr LitObject kLitObjects[] = {LitObject::diffuse, LitObject::glossy, LitObject::shaded};

struct ObjectLook {
    int size = 192;           // pixels, square
    double turn_degrees = 0;  // of the light about the up axis, see turned_about_up()
    double exposure = 1;      // the factor on radiance; objects reflect all of their light
};

/// sRGB-encoded, transparent around the object, where its rim's colours go on: who enlarges the picture mixes
/// no others into it. Seen by one who looks towards the map's centre, +Z, from far away, on ground from
/// above too: the light of the map's left falls on the sphere's left.
Grid<glm::u8vec4> object_picture(const LitObjects& objects, LitObject object, const ObjectLook& look);

}  // namespace dapple
