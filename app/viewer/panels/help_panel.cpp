#include "app/viewer/panels/window_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

// In letters' heights: of what keys mean, and of all that is beside it.
constexpr float kNarrowest = 8, kWidest = 24, kAir = 6;
constexpr std::size_t kLeftGroups = 2;

struct KeyRow {
    const char *keys, *meaning;
};
struct KeyGroup {
    const char* title;
    std::vector<KeyRow> rows = {};
};

std::vector<KeyGroup> groups_of(std::span<const Shortcut> shortcuts) {
    // As ActionGroup has them.
    std::vector<KeyGroup> groups{{"Files"}, {"View"}, {"Drawing"}, {"The method"}, {"The program"}};
    for (const Shortcut& shortcut : shortcuts)
        if (*shortcut.keys)
            groups[static_cast<std::size_t>(group_of(shortcut.action))].rows.push_back(
                {shortcut.keys, shortcut.meaning});
    groups[0].rows.push_back({"Drop a file", "Open it, or draw with it (.tile)"});
    std::vector<KeyRow>& view = groups[1].rows;
    view.insert(view.begin(), {{"Wheel", "Zoom at the pointer"}, {"Drag", "Move the view"}});
    groups.push_back({"On a row",
                      {{"Tab, Shift+Tab", "Next or previous row"},
                       {"Arrows", "Change it; Shift: ten times as far, Alt: a tenth"},
                       {"Enter, Space", "Type its value, press it, open its list"},
                       {"Backspace", "Reset to the default"},
                       {"Ctrl+click", "On a slider: type the number"},
                       {"Double-click", "On its name: reset to the default"}}});
    std::erase_if(groups, [](const KeyGroup& group) { return group.rows.empty(); });
    return groups;
}

float keys_width() {
    push_title_font();
    const float width = ImGui::CalcTextSize("Ctrl+Y, Ctrl+Shift+Z").x;
    pop_title_font();
    return width;
}

void draw_bold(const char* words) {
    push_title_font();
    ImGui::TextUnformatted(words);
    pop_title_font();
}

void draw_groups(std::span<const KeyGroup> groups, const char* id, float room) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit,
                           {keys_width() + room + ImGui::GetTextLineHeight(), 0}))
        return;
    for (const KeyGroup& group : groups) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", group.title);
        for (const KeyRow& row : group.rows) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            draw_bold(row.keys);
            ImGui::TableNextColumn();
            ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
            ImGui::TextUnformatted(row.meaning);
            ImGui::PopTextWrapPos();
        }
        ImGui::TableNextRow(0, ImGui::GetTextLineHeight() / 2);
    }
    ImGui::EndTable();
}

}  // namespace

void draw_help_panel(bool& open, std::span<const Shortcut> shortcuts) {
    const Dialog dialog("Keys", open);
    if (!dialog) return;
    // In a narrow window the words are wrapped, and in a wide one two columns stand side by side.
    const float line = ImGui::GetTextLineHeight(), keys = keys_width();
    const float all = ImGui::GetIO().DisplaySize.x - kAir * line;
    const bool two = all > 2 * (keys + kWidest * line);
    const float room = std::clamp(all - keys, kNarrowest * line, kWidest * line);
    const std::vector<KeyGroup> groups = groups_of(shortcuts);
    const std::size_t left = two ? std::min(kLeftGroups, groups.size()) : groups.size();
    draw_groups(std::span(groups).first(left), "keys", room);
    if (two) {
        ImGui::SameLine();
        draw_groups(std::span(groups).subspan(left), "more keys", room);
    }
    if (help_pressed() && !ImGui::IsWindowAppearing()) open = false;
}

}  // namespace dapple
