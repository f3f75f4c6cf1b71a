#pragma once
// How the canvas shows what is compared.

#include "app/viewer/canvas/canvas.h"
#include "app/viewer/model/compared_panes.h"

namespace dapple {

/// `pixel_scale`: see CanvasLook.
SplitLook look_of(const ComparedPanes& compared, const Zoom& zoom, float pixel_scale);

/// Where a picture that is framed so comes from, of one of so many pixels.
PictureView view_of(const Framing& framing, glm::ivec2 picture);

}  // namespace dapple
