#pragma once
// What lights do to a diffuse surface: the integral of radiance times cosine over the hemisphere of a normal.
// Or to a glossy one, which has a power of the cosine (Phong 1975).

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/image/environment.h"

namespace dapple {

/// A light that is far away: a unit vector towards it, and the irradiance on a surface that faces it.
struct DistantLight {
    glm::dvec3 direction{};
    glm::dvec3 weight{};
};

/// Every texel of the map as a light at its centre, weight = radiance * solid angle, directions as in
/// OpenEXR; black ones left out.
std::vector<DistantLight> texel_lights(const EnvironmentMap& map);

/// A light for each block of so many texels a side, with all their light, from its centre of gravity: for
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

}  // namespace dapple
