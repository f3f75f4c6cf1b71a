#include "app/viewer/panels/help_panel.h"

#include <imgui.h>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

void row(const char* keys, const char* meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    push_title_font();
    ImGui::TextUnformatted(keys);
    pop_title_font();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(meaning);
}

}  // namespace

void draw_help_panel(bool& open, std::span<const Shortcut> shortcuts) {
    if (open && !ImGui::IsPopupOpen("Keys")) ImGui::OpenPopup("Keys");
    ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(
            "Keys", &open,
            ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
        return;
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        row("Wheel", "Zoom at the pointer");
        row("Drag", "Move the view");
        for (const Shortcut& shortcut : shortcuts) row(shortcut.keys, shortcut.meaning);
        row("Ctrl+click", "On a slider: type the number");
        row("Double-click", "On a slider's name: back to neutral");
        row("Drop a file", "Open it; a .tile is drawn with");
        ImGui::EndTable();
    }
    bool outside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered();
    const bool again = help_pressed() && !ImGui::IsWindowAppearing();
    if (outside || again || escape_pressed()) open = false;
    if (!open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace dapple
