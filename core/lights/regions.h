#pragma once
// The light of a map shared out among dots.
//
// Between the centres of four texels lies a patch; the density is bilinear there, as if each texel gave every
// one of its four patches a quarter of its light. A patch that holds dots is theirs, in equal parts. Another
// one is that of the nearest dot on the sphere, found by passing owners on from patch to patch, down the map
// and up again, around the sides. So the parts sum to the whole exactly, a sun of one texel is split
// among all dots that it got, and the cost is that of a few looks at each texel whatever the dots are.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/image/environment.h"
#include "core/lights/light_watch.h"

namespace dapple {

struct LightRegion {
    glm::dvec3 flux{};       // linear RGB; over all regions, the map's total flux
    double solid_angle = 0;  // steradians; over all regions, 4 pi
    glm::dvec3 moment{};     // the integral of power * direction, directions as in OpenEXR
    glm::dvec2 drawn{};      // u, v of a place drawn at random in proportion to power
    double power = 0;        // 0: moment and drawn say nothing
};

/// One for each dot (u in [0, 1), v in [0, 1]). Dots at the same place share alike. `power` is what dots were
/// placed by, a texel's whole. Places are drawn if there is a seed. Nothing if stopped.
std::vector<LightRegion> share_light(const EnvironmentMap& map, const Grid<float>& power,
                                     std::span<const glm::dvec2> dots, std::optional<std::uint64_t> seed = {},
                                     const LightWatch& watch = {});

}  // namespace dapple
