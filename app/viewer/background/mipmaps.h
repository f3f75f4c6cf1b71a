#pragma once
// A picture in ever smaller copies, so that a drawing of it from afar looks at few of its pixels.
//
// Made here, beside the window's thread, and not by OpenGL, which makes all of them in one frame.

#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// The picture itself, then copies of half the sides, rounded down, to one of a single pixel. Each pixel is
/// the mean of four. None of an empty picture.
std::vector<Grid<glm::u8vec4>> mipmaps_of(Grid<glm::u8vec4> picture);

/// The largest of them whose longer side is at most so long; empty if there is none.
Grid<glm::u8vec4> small_copy(const std::vector<Grid<glm::u8vec4>>& mipmaps, int longest_side);

}  // namespace dapple
