#pragma once
// The crop as a frame over the whole picture, with edges and corners to drag.

#include <glm/vec2.hpp>
#include <optional>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/view/camera.h"
#include "core/drawing/page_setup.h"

namespace dapple {

/// Where on a picture that is framed so a pixel of the picture as it was opened lies: opened_pixel() the
/// other way round.
glm::dvec2 framed_pixel(const Framing& framing, glm::dvec2 opened);

class CropFrame {
 public:
    /// Moves the crop as the left button asks in this frame, of a picture that is shown uncropped, framed so.
    /// It is kept to a proportion as in_proportion() has it; 0: to none. True while it is held there.
    bool drag(std::optional<Crop>& crop, double proportion, const Framing& framing, glm::ivec2 picture,
              const Camera& camera, const CanvasPlace& place);

    /// Over the canvas, behind ImGui's windows: what is cut away is darkened.
    void draw(const std::optional<Crop>& crop, const Framing& framing, glm::ivec2 picture,
              const Camera& camera, const CanvasPlace& place) const;

 private:
    /// Which sides move: -1 the left or upper one, 1 the right or lower one, 0 neither; both 0: all of it.
    struct Held {
        glm::ivec2 sides;
        Rectangle<double> box;  // as it was, in percent
        glm::dvec2 from;        // of the pointer, in percent
    };
    std::optional<Held> held_;
};

}  // namespace dapple
