#include "app/viewer/widgets/dialog.h"

#include <imgui.h>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

bool begin_dialog(const char* title, bool& open, ImGuiWindowFlags flags) {
    if (open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, style.PopupBorderSize);
    // Of the title alone, which would else begin left of all that is below it.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.WindowPadding.x, 2 * style.FramePadding.y});
    const bool drawn =
        ImGui::BeginPopupModal(title, &open, flags | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    ImGui::PopStyleVar(2);
    if (!drawn) return false;
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    note_place("Dialog", {{low.x, low.y}, {low.x + size.x, low.y + size.y}});
    return true;
}

Dialog::Dialog(const char* title, bool& open)
    : open_(open), drawn_(begin_dialog(title, open, ImGuiWindowFlags_AlwaysAutoResize)) {}

Dialog::~Dialog() {
    if (!drawn_) return;
    const bool outside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (outside || key_pressed(Key::escape)) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace dapple
