#include "app/viewer/canvas/camera_mouse.h"

#include <imgui.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace dapple {

bool CameraMouse::move(Camera& camera, const CanvasPlace& place, bool left_taken) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer{io.MousePos.x, io.MousePos.y};
    const auto inside = [&](glm::vec2 p) {
        return glm::all(glm::greaterThanEqual(p, place.corner)) &&
               glm::all(glm::lessThan(p, place.corner + place.size));
    };
    bool held = false, moved = false;
    for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle}) {
        if (left_taken && button == ImGuiMouseButton_Left) continue;
        held |= ImGui::IsMouseDown(button);
        const glm::vec2 press{io.MouseClickedPos[button].x, io.MouseClickedPos[button].y};
        if (ImGui::IsMouseClicked(button) && !io.WantCaptureMouse && inside(press)) held_at_ = press;
    }
    if (!held) held_at_.reset();
    if (held_at_ && pointer != *held_at_) {
        camera = dragged(camera, glm::dvec2(pointer - *held_at_) * place.pixels_per_point);
        held_at_ = pointer;
        moved = true;
    }
    if (io.MouseWheel != 0 && !io.WantCaptureMouse && inside(pointer)) {
        const glm::dvec2 at(pointer - place.corner);
        camera = zoomed_at(camera, at * place.pixels_per_point, std::pow(1.2, io.MouseWheel));
        moved = true;
    }
    if (held_at_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    return moved;
}

}  // namespace dapple
