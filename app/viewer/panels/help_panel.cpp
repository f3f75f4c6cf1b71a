#include "app/viewer/panels/window_panels.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

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

namespace {

constexpr float kWidth = 30, kNamesWidth = 21;  // letters' heights

struct Libraries {
    const char* licence;
    std::string names;
};

}  // namespace

bool draw_preferences(Appearance& appearance, DialogChoice& dialog, LengthUnit* unit) {
    bool changed = segmented_row("Theme", appearance.theme, std::array{"light", "dark", "high contrast"},
                                 "Colours of the window; the drawing and its files stay the same.");
    int size = appearance.text_size < 0.95f  ? 0
               : appearance.text_size < 1.1f ? 1
               : appearance.text_size < 1.4f ? 2
                                             : 3;
    if (segmented_row("Text", size, std::array{"small", "normal", "large", "huge"},
                      "Size of text and rows, in addition to the desktop's scale.", 1)) {
        appearance.text_size = std::array{0.85f, 1.0f, 1.25f, 1.6f}[static_cast<std::size_t>(size)];
        changed = true;
    }
    changed |=
        segmented_row("Open with", dialog, std::array{"Dapple's dialog", "system"},
                      "Dialog for opening files. The system's needs zenity or kdialog. Exports always use "
                      "Dapple's dialog, for its options.",
                      DialogChoice::desktop);
    if (unit)
        segmented_row("Lengths in", *unit, std::array{"mm", "inch"},
                      "Unit of lengths shown, and of numbers typed without one; 8in and 21cm work in both.");
    return changed;
}

bool draw_preferences_panel(bool& open, Appearance& appearance, DialogChoice& dialog, LengthUnit* unit) {
    const Dialog shown("Preferences", open);
    if (!shown) return false;
    ImGui::Dummy({kWidth * ImGui::GetTextLineHeight(), 0});
    return draw_preferences(appearance, dialog, unit);
}

void draw_about_panel(bool& open) {
    const Dialog dialog("About Dapple", open);
    if (!dialog) return;
    push_title_font();
    ImGui::TextUnformatted("Dapple " DAPPLE_VERSION);
    pop_title_font();
    ImGui::PushTextWrapPos(kWidth * ImGui::GetTextLineHeight());
    ImGui::TextUnformatted(
        "Photographs as dots, in real time. The method is by Ares Lagae and Philip Dutré (2006): a "
        "self-similar hierarchical tile, divided again and again.");
    ImGui::TextUnformatted("Free to use, change and share under the MIT licence.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, ImGui::GetTextLineHeight() / 2});
    const std::string all = glfwGetVersionString(), glfw = all.substr(0, all.find(' '));
    const std::array all_of_a_licence{
        Libraries{"MIT", "Dear ImGui " IMGUI_VERSION
                         ", GLM, {fmt}, nlohmann-json, CLI11, libepoxy, stb, Little CMS"},
        Libraries{"zlib", "GLFW " + glfw + ", zlib"},
        Libraries{"BSD", "OpenImageIO, libwebp, KISS FFT"},
        Libraries{"Apache 2.0", "oneTBB, qpdf"},
        Libraries{"LGPL or MPL", "Cairo"},
        Libraries{"their own, free", "libpng, libjpeg-turbo, libtiff, fontconfig"}};
    ImGui::TextUnformatted("Built on these libraries, by licence:");
    if (!ImGui::BeginTable("libraries", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const auto& [licence, names] : all_of_a_licence) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", licence);
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + kNamesWidth * ImGui::GetTextLineHeight());
        ImGui::TextUnformatted(names.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
}

}  // namespace dapple
