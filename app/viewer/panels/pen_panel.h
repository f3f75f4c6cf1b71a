#pragma once
// The section "Pens": which pens draw, and the colours of ink and paper.

#include "app/drawing_settings.h"
#include "core/text/length.h"

namespace dapple {

/// True while something changes. Pens of one's own are listed at the end: each has a name, a colour, a width,
/// a smallest gap and a dot gain, and can be removed while there is another.
bool draw_pen_panel(DrawingSettings& settings, LengthUnit unit = LengthUnit::mm);

}  // namespace dapple
