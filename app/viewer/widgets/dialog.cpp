#include "app/viewer/widgets/dialog.h"

#include <imgui.h>

#include "app/viewer/widgets/keys.h"

namespace dapple {

Dialog::Dialog(const char* title, bool& open) : open_(open) {
    if (open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    drawn_ = ImGui::BeginPopupModal(
        title, &open,
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
}

Dialog::~Dialog() {
    if (!drawn_) return;
    const bool outside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (outside || key_pressed(Key::escape)) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace dapple
