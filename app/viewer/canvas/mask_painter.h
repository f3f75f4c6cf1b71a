#pragma once
// The mask over the canvas: painted with the mouse, and shown as a tint while the brush is there.

#include <optional>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/model/mask_brush.h"

namespace dapple {

class MaskPainter {
 public:
    /// Paints what the left button does over the canvas in this frame, on the picture of a drawing, unless
    /// ImGui's windows want the mouse. True while a stroke goes on: the button is then nobody else's.
    bool paint(Mask& mask, const MaskBrush& tool, const PlacedDrawing& shown, const Camera& camera,
               const CanvasPlace& place);

    /// Over the canvas, behind ImGui's windows: red where dots are taken away, blue where there are more, and
    /// the brush as a ring.
    void draw(const Mask& mask, const MaskBrush& tool, const PlacedDrawing& shown, const Camera& camera,
              const CanvasPlace& place);

 private:
    std::optional<BrushStroke> stroke_;
    GlTexture tint_;
    Mask tinted_;  // what tint_ shows
};

}  // namespace dapple
