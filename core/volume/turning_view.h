#pragma once
// Dots in space seen from around them: a picture for each moment of one turn.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/image/grid.h"

namespace dapple {

/// A square picture, sRGB, of balls of equal size from afar: `turn` 0..1 is how far round the z axis, which
/// points up, they have turned; one looks down on them a little. Nearer ones are darker and hide others. All
/// of them are in the picture whatever the turn.
Grid<glm::u8vec3> turned_view(std::span<const glm::dvec3> dots, double turn, int side);

}  // namespace dapple
