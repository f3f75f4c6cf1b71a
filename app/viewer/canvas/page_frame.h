#pragma once
// The margins as lines on the page.

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/model/camera.h"
#include "core/drawing/page_setup.h"

namespace dapple {

/// Over the canvas, behind ImGui's windows; nothing on a page without margins.
void draw_margin_lines(const PageLayout& layout, const Camera& camera, const CanvasPlace& place);

}  // namespace dapple
