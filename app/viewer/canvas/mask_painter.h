#pragma once
// What the left button changes over the canvas: the mask, which is painted, and shown as a tint while the
// brush is there, and single dots.

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/model/mask_brush.h"
#include "core/drawing/edits.h"

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

class Retoucher {
 public:
    /// Adds to the edits what the button did to the whole page of a drawing, once it is let go. Draws, behind
    /// ImGui's windows, what it would do or does. Throws std::runtime_error if there would be too many edits,
    /// and adds none.
    void retouch(std::string& edits, const RetouchTool& tool, const PlacedDrawing& shown,
                 const Camera& camera, const CanvasPlace& place);

 private:
    std::string edits_made(const RetouchTool& tool, const PlacedDrawing& shown, float resized_mm) const;

    std::vector<glm::vec2> way_;  // the pointer's since the button went down, in mm; empty: it is up
    std::optional<Edit> dot_;     // the one under it, or where it went down, as if it had been added
};

}  // namespace dapple
