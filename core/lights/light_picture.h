#pragma once
// An environment map with its samples drawn over it: the paper's figure 7.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "core/image/environment.h"
#include "core/image/grid.h"

namespace dapple {

/// The factor on radiance with which a map's typical light is mid-grey: 0.18 over the geometric mean of the
/// luminance of the texels that have light, weighted by solid angle.
double natural_exposure(const EnvironmentMap& map);

/// sRGB-encoded. Light is exposed, then pressed together, L / (1 + L), so that lamps keep their colour.
glm::u8vec3 tone_mapped(const glm::dvec3& radiance, double exposure);

/// The map, each texel a square of so many pixels that the picture is at least 2,048 wide, and a white disc
/// with a dark rim at each place (u, v), so many pixels in radius.
Grid<glm::u8vec3> light_picture(const EnvironmentMap& map, std::span<const glm::dvec2> places,
                                double exposure, double disc_radius = 2);

}  // namespace dapple
