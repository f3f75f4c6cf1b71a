#pragma once
// The tool "Mask": the brush that paints where there are more dots, fewer or none.

#include "app/viewer/model/mask_brush.h"
#include "core/image/mask.h"

namespace dapple {

/// The brush's rows, and a button that clears the mask. True when the mask changed.
bool draw_mask_panel(Mask& mask, MaskBrush& brush);

}  // namespace dapple
