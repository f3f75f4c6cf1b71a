#pragma once
// How the canvas shows a pane, and which of its dots are in view.

#include "app/viewer/canvas/renderer.h"
#include "app/viewer/model/session.h"
#include "app/viewer/model/view_analysis.h"

namespace dapple {

/// `pixel_scale`: see CanvasLook.
CanvasLook look_of(const Session& session, const Pane& pane, const Zoom& zoom, float pixel_scale);

/// Where a picture that is framed so comes from, of one of so many pixels.
PictureView view_of(const Framing& framing, glm::ivec2 picture);

PointsInView points_on_screen(const PlacedDrawing& shown, const Camera& camera);

}  // namespace dapple
