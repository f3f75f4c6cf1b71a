#pragma once
// The pen of a plot that is shown, and where it came from.

#include <glm/vec2.hpp>
#include <span>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/view/camera.h"

namespace dapple {

/// Draws the pen at the last of the places, page units from the picture's corner, with a line through those
/// before it that fades.
void draw_pen_trail(std::span<const glm::dvec2> places, const Camera& camera, const CanvasPlace& place);

}  // namespace dapple
