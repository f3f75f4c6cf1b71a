#pragma once
// Which way in space a place (u, v) on a latitude-longitude map lies, in the ways renderers have it.
//
//      convention              up   centre (u = 1/2)   u = 1/4
//      OpenEXR, USD DomeLight  +Y   +Z                 +X
//      Mitsuba 3               +Y   +Z                 +X
//      Blender Cycles          +Z   +X                 +Y
//      pbrt (v3's maps)        +Z   -X                 +Y

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/export.h"
#include "core/text/names.h"

namespace dapple {

enum class SphereConvention { openexr, usd, mitsuba, blender, pbrt };
constexpr auto names_of(SphereConvention) {
    return names("openexr", "usd", "mitsuba", "blender", "pbrt");
}

/// The unit vector towards (u, v), u around and v from top to bottom, both 0..1.
DAPPLE_API glm::dvec3 direction_of(glm::dvec2 uv, SphereConvention convention);

/// The way back: u in [0, 1), v in [0, 1]. The vector need not have length 1.
glm::dvec2 uv_of(glm::dvec3 direction, SphereConvention convention);

/// Turned about the convention's up axis by the right-hand rule: 90 degrees take +Z to +X where +Y is up, and
/// +X to +Y where +Z is up.
glm::dvec3 turned_about_up(glm::dvec3 direction, double degrees, SphereConvention convention);

}  // namespace dapple
