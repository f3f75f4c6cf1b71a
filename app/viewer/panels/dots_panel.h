#pragma once
// The sections "Dots", "Page" and "Pen": how many dots there are, how large, how even; how large the page is,
// and in which colours.

#include "app/drawing_settings.h"
#include "app/viewer/model/drawn_info.h"

namespace dapple {

/// Each true while something changes.
bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn);
bool draw_page_panel(DrawingSettings& settings);
bool draw_pen_panel(DrawingSettings& settings);

}  // namespace dapple
