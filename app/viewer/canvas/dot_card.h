#pragma once
// A card beside the pointer that says where the dot under it comes from; its tile lights up.

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/view/dot_origin.h"

namespace dapple {

/// Over the canvas; nothing where no dot is near, or where ImGui's windows have the mouse.
void draw_dot_card(const PlacedDrawing& shown, const PlacedWith& with, const Camera& camera,
                   const CanvasPlace& place);

}  // namespace dapple
