#pragma once
// The section "Pens": the colours of ink and paper.

#include "app/drawing_settings.h"

namespace dapple {

/// True while something changes.
bool draw_pen_panel(DrawingSettings& settings);

}  // namespace dapple
