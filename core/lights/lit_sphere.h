#pragma once
// A diffuse white sphere in the light of a map or of its samples.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/image/grid.h"
#include "core/lights/irradiance.h"

namespace dapple {

/// The irradiance for every normal, on a latitude-longitude grid of 48 x 24 normals, directions as in
/// OpenEXR.
class IrradianceMap {
 public:
    explicit IrradianceMap(std::span<const DistantLight> lights);

    /// Bilinear.
    glm::dvec3 at(glm::dvec3 normal) const;

    const Grid<glm::dvec3>& values() const { return values_; }

 private:
    Grid<glm::dvec3> values_;
};

/// Mean over the sphere's normals of |E - exact| / exact in luminance; normals without light are left out.
double difference(const IrradianceMap& found, const IrradianceMap& exact);

struct SphereLook {
    int size = 192;           // pixels, square
    double turn_degrees = 0;  // of the light about the up axis, see turned_about_up()
    double exposure = 1;      // the factor on radiance; the sphere reflects all of its light
};

/// sRGB-encoded, transparent around the sphere, where its rim's colours go on: who enlarges the picture mixes
/// no others into it. Seen by one who looks towards the map's centre, +Z, from far
/// away: the light of the map's left falls on the sphere's left.
Grid<glm::u8vec4> sphere_picture(const IrradianceMap& light, const SphereLook& look);

}  // namespace dapple
