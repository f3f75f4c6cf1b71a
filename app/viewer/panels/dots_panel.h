#pragma once
// The sections "Dots" and "Pen": how many dots there are, how large, how even, in which colours.

#include "app/drawing_settings.h"
#include "app/viewer/model/drawn_info.h"

namespace dapple {

/// Each true while something changes.
bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn);
bool draw_pen_panel(DrawingSettings& settings);

}  // namespace dapple
