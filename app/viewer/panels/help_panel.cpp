#include "app/viewer/panels/help_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

// In letters' heights: of what keys mean, and of all that is beside it.
constexpr float kNarrowest = 8, kWidest = 34, kAir = 6;

void draw_row(const char* keys, const char* meaning, float room) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    push_title_font();
    ImGui::TextUnformatted(keys);
    pop_title_font();
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(meaning);
    ImGui::PopTextWrapPos();
}

}  // namespace

void draw_help_panel(bool& open, std::span<const Shortcut> shortcuts) {
    const Dialog dialog("Keys", open);
    if (!dialog) return;
    // In a narrow window the words are wrapped.
    push_title_font();
    const float keys = ImGui::CalcTextSize("Tab, Shift+Tab").x;
    pop_title_font();
    const float line = ImGui::GetTextLineHeight();
    const float room =
        std::clamp(ImGui::GetIO().DisplaySize.x - keys - kAir * line, kNarrowest * line, kWidest * line);
    const auto row = [&](const char* which, const char* meaning) { draw_row(which, meaning, room); };
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        row("Wheel", "Zoom at the pointer");
        row("Drag", "Move the view");
        for (const Shortcut& shortcut : shortcuts)
            if (*shortcut.keys) row(shortcut.keys, shortcut.meaning);
        row("Tab, Shift+Tab", "The next row, the row before");
        row("Arrows", "On a row: change it, ten times as far with Shift, a tenth with Alt");
        row("Enter, Space", "On a row: type its value, press it, open its list");
        row("Backspace", "On a row: back to the usual value");
        row("Ctrl+click", "On a slider: type the number");
        row("Double-click", "On a row's name: back to the usual value");
        row("Drop a file", "Open it; a .tile is drawn with");
        ImGui::EndTable();
    }
    if (help_pressed() && !ImGui::IsWindowAppearing()) open = false;
}

}  // namespace dapple
