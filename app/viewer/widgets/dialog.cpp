#include "app/viewer/widgets/dialog.h"

#include <imgui.h>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

bool begin_dialog(const char* title, bool& open, ImGuiWindowFlags flags, DialogPlace place) {
    if (open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    constexpr float kTop = 0.08f;  // of the window's height
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const bool top = place == DialogPlace::top;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y * (top ? kTop : 0.5f)}, ImGuiCond_Always,
                            {0.5f, top ? 0 : 0.5f});
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, style.PopupBorderSize);
    // For the title alone, which would otherwise begin left of all that is below it.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.WindowPadding.x, 2 * style.FramePadding.y});
    const bool drawn =
        ImGui::BeginPopupModal(title, &open, flags | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    ImGui::PopStyleVar(2);
    if (!drawn) return false;
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    note_place("Dialog", {{low.x, low.y}, {low.x + size.x, low.y + size.y}});
    return true;
}

Dialog::Dialog(const char* title, bool& open, DialogPlace place)
    : open_(open), drawn_(begin_dialog(title, open, ImGuiWindowFlags_AlwaysAutoResize, place)) {}

Dialog::~Dialog() {
    // No frame follows what was thrown in it, and ImGui would insist on what was left open.
    if (!drawn_ || std::uncaught_exceptions() > failures_) return;
    const bool outside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (outside || key_pressed(Key::escape)) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace dapple
