#include "app/viewer/canvas/camera_mouse.h"

#include <cmath>
#include <glm/vector_relational.hpp>

namespace dapple {

bool CanvasPlace::holds(ImVec2 point) const {
    const glm::vec2 p{point.x, point.y};
    return glm::all(glm::greaterThanEqual(p, corner)) && glm::all(glm::lessThan(p, corner + size));
}

ImVec2 CanvasPlace::point_of(glm::dvec2 pixel) const {
    const glm::vec2 point = corner + glm::vec2(pixel / pixels_per_point);
    return {point.x, point.y};
}

PagePoint CanvasPlace::page_at(ImVec2 point, const Camera& camera) const {
    return point_at(camera, glm::dvec2(point.x - corner.x, point.y - corner.y) * pixels_per_point);
}

void CanvasPlace::clip(ImDrawList* list) const {
    list->PushClipRect({corner.x, corner.y}, {corner.x + size.x, corner.y + size.y}, true);
}

bool CameraMouse::move(Camera& camera, const CanvasPlace& place, bool left_taken) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer{io.MousePos.x, io.MousePos.y};
    bool held = false, moved = false;
    for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle}) {
        if (left_taken && button == ImGuiMouseButton_Left) continue;
        held |= ImGui::IsMouseDown(button);
        const ImVec2 press = io.MouseClickedPos[button];
        if (ImGui::IsMouseClicked(button) && !io.WantCaptureMouse && place.holds(press))
            held_at_ = {press.x, press.y};
    }
    if (!held) held_at_.reset();
    if (held_at_ && pointer != *held_at_) {
        camera = dragged(camera, glm::dvec2(pointer - *held_at_) * place.pixels_per_point);
        held_at_ = pointer;
        moved = true;
    }
    if (io.MouseWheel != 0 && !io.WantCaptureMouse && place.holds(io.MousePos)) {
        const glm::dvec2 at(pointer - place.corner);
        camera = zoomed_at(camera, at * place.pixels_per_point, std::pow(1.2, io.MouseWheel));
        moved = true;
    }
    if (held_at_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    return moved;
}

}  // namespace dapple
