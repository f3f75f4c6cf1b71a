#pragma once
// The tool "Mask": the brush that paints where there are more dots, fewer or none, and where they are finer.

#include "app/viewer/model/mask_brush.h"
#include "core/drawing/request.h"

namespace dapple {

/// The brush's rows, and a button that clears the drawing's mask. True when the mask changed.
bool draw_mask_panel(DrawingRequest& drawing, MaskBrush& brush);

}  // namespace dapple
