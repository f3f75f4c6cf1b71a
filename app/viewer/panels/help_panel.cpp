#include "app/viewer/panels/help_panel.h"

#include <imgui.h>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/theme.h"

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
    const Dialog dialog("Keys", open);
    if (!dialog) return;
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        row("Wheel", "Zoom at the pointer");
        row("Drag", "Move the view");
        for (const Shortcut& shortcut : shortcuts)
            if (*shortcut.keys) row(shortcut.keys, shortcut.meaning);
        row("Ctrl+click", "On a slider: type the number");
        row("Double-click", "On a slider's name: back to neutral");
        row("Drop a file", "Open it; a .tile is drawn with");
        ImGui::EndTable();
    }
    if (help_pressed() && !ImGui::IsWindowAppearing()) open = false;
}

}  // namespace dapple
