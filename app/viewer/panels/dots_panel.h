#pragma once
// The section "Drawing": how many dots there are, how large, how even, in which shape.

#include "app/viewer/model/drawn_info.h"
#include "core/drawing/settings.h"
#include "core/text/length.h"

namespace dapple {

/// True while something changes.
bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn, LengthUnit unit = LengthUnit::mm);

}  // namespace dapple
