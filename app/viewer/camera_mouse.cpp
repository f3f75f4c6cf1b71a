#include "app/viewer/camera_mouse.h"

#include <imgui.h>

#include <cmath>

namespace dapple {

bool CameraMouse::move(Camera& camera, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer{io.MousePos.x, io.MousePos.y};
    bool held = false, moved = false;
    for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle}) {
        held |= ImGui::IsMouseDown(button);
        if (ImGui::IsMouseClicked(button) && !io.WantCaptureMouse)
            held_at_ = {io.MouseClickedPos[button].x, io.MouseClickedPos[button].y};
    }
    if (!held) held_at_.reset();
    if (held_at_ && pointer != *held_at_) {
        camera = dragged(camera, glm::dvec2(pointer - *held_at_) * place.pixels_per_point);
        held_at_ = pointer;
        moved = true;
    }
    if (io.MouseWheel != 0 && !io.WantCaptureMouse) {
        const glm::dvec2 at(pointer - place.corner);
        camera = zoomed_at(camera, at * place.pixels_per_point, std::pow(1.2, io.MouseWheel));
        moved = true;
    }
    if (held_at_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    return moved;
}

}  // namespace dapple
