#pragma once
// The mouse on a canvas: the wheel zooms at the pointer, a drag moves the page.

#include <imgui.h>
#include <glm/vec2.hpp>
#include <optional>

#include "app/viewer/view/camera.h"

namespace dapple {

/// Where the canvas lies, in ImGui's points.
struct CanvasPlace {
    glm::vec2 corner{0}, size{1};
    glm::dvec2 pixels_per_point{1, 1};

    bool holds(ImVec2 point) const;
    /// Where a pixel of it lies, and what of the page lies at a point.
    ImVec2 point_of(glm::dvec2 pixel) const;
    PagePoint page_at(ImVec2 point, const Camera& camera) const;
    /// Nothing is drawn beyond it until the list's PopClipRect().
    void clip(ImDrawList* list) const;
};

class CameraMouse {
 public:
    /// Moves the camera as the mouse of this frame asks, unless ImGui's windows want it or it is elsewhere: a
    /// drag begins where the button went down, however far the pointer came in the frame before. True if it
    /// moved.
    /// `left_taken`: the left button is somebody else's.
    bool move(Camera& camera, const CanvasPlace& place, bool left_taken = false);

 private:
    std::optional<glm::vec2> held_at_;  // while dragging: where the pointer was, in points
};

}  // namespace dapple
