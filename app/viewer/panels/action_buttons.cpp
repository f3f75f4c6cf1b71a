#include "app/viewer/panels/action_buttons.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row_keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr int kButtonsARow = 3;

// Three short lines, as menus are known by.
bool menu_button(ImVec2 size) {
    const bool pressed = press_area("Menu", size);
    note_place("Menu");
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float unit = ImGui::GetTextLineHeight() / 15, half = 6.5f * unit;
    const float x = std::floor((low.x + high.x) / 2), y = std::floor((low.y + high.y) / 2);
    const bool hot = ImGui::IsItemHovered();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (hot)
        list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_ButtonHovered),
                            ImGui::GetStyle().FrameRounding);
    for (const float line : {-4.5f, 0.0f, 4.5f})
        list->AddRectFilled({x - half, y + (line - 0.75f) * unit}, {x + half, y + (line + 0.75f) * unit},
                            colour_of(hot ? ThemeColour::text : ThemeColour::quiet));
    tip("All commands, keys, preferences, and what Dapple is.");
    return item_keys("Menu keys").press || pressed;
}

constexpr Action kCanvasMenu[] = {Action::fit, Action::one_to_one, Action::photograph, Action::copy_picture,
                                  Action::save_as};
constexpr Action kMenu[] = {Action::palette, Action::help, Action::full_screen, Action::preferences,
                            Action::about};

// What was chosen, which is done once the menu is closed.
std::optional<Action> draw_menu(const char* name, std::span<const Action> entries) {
    if (!ImGui::BeginPopup(name)) return std::nullopt;
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID mark = ImGui::GetID("marked");
    const auto last = static_cast<int>(entries.size()) - 1;
    const auto down = [](Key key) { return ImGui::IsKeyPressed(key_code(key), true) ? 1 : 0; };
    if (ImGui::IsWindowAppearing()) storage->SetInt(mark, -1);
    const int walked = down(Key::down) - down(Key::up);
    const int marked =
        walked == 0 ? storage->GetInt(mark) : std::clamp(storage->GetInt(mark) + walked, 0, last);
    storage->SetInt(mark, marked);
    std::optional<Action> chosen;
    for (int i = 0; i <= last; ++i) {
        const Action action = entries[static_cast<std::size_t>(i)];
        const Shortcut& entry = shortcut_of(action);
        const bool entered = i == marked && (key_pressed(Key::enter) || key_pressed(Key::keypad_enter));
        if (ImGui::MenuItem(entry.label, entry.keys, i == marked) || entered) chosen = action;
        note_place(entry.label);
    }
    if (chosen || key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
    take_keyboard();
    ImGui::EndPopup();
    return chosen;
}

bool action_button(Action action, int column) {
    const char* const label = shortcut_of(action).label;
    const float air = ImGui::GetStyle().ItemSpacing.x;
    if (column > 0) ImGui::SameLine();
    // The width of the whole row, wherever in it the cursor is.
    const float row = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const bool pressed = key_button(label, {(row - (kButtonsARow - 1) * air) / kButtonsARow, 0});
    note_place(label);
    return pressed;
}

void undo_button(const std::optional<std::string>& words, Action action, int column,
                 const std::function<void(Action)>& act) {
    if (!words) ImGui::BeginDisabled();
    if (action_button(action, column)) act(action);
    if (!words) ImGui::EndDisabled();
    if (words)
        tip(with_keys(
                fmt::format("{}: {}", shortcut_of(action).label, words->empty() ? "the last change" : *words),
                action)
                .c_str());
}

}  // namespace

void draw_title(const std::string& name, const std::function<void(Action)>& act) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 button{ImGui::GetFrameHeight() * 1.2f, ImGui::GetFrameHeight()};
    const float air = (button.y - ImGui::GetTextLineHeight()) / 2;
    push_title_font();
    ImGui::PushClipRect(start, {start.x + std::max(width - button.x - air, 1.0f), start.y + button.y}, true);
    ImGui::SetCursorScreenPos({start.x, start.y + air});
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopClipRect();
    pop_title_font();
    const ImVec2 place{start.x + std::max(width - button.x, 0.0f), start.y};
    ImGui::SetCursorScreenPos(place);
    if (menu_button(button)) ImGui::OpenPopup("menu");
    const float below = button.y + ImGui::GetStyle().ItemSpacing.y;
    ImGui::SetNextWindowPos({place.x + button.x, place.y + below}, ImGuiCond_Always, {1, 0});
    if (const std::optional<Action> chosen = draw_menu("menu", kMenu)) act(*chosen);
    ImGui::SetCursorScreenPos({start.x, start.y + button.y});
    ImGui::Dummy({0, 0});
    ImGui::SetCursorScreenPos({start.x, start.y + button.y});
}

void draw_canvas_menu(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 press = io.MouseClickedPos[ImGuiMouseButton_Right];
    const bool inside = press.x >= corner.x && press.x < corner.x + size.x && press.y >= corner.y &&
                        press.y < corner.y + size.y;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !io.WantCaptureMouse && inside)
        ImGui::OpenPopup("canvas menu");
    if (const std::optional<Action> chosen = draw_menu("canvas menu", kCanvasMenu)) act(*chosen);
}

void draw_action_buttons(const UndoInfo& info, bool has_project, const std::function<void(Action)>& act) {
    const auto button = [&](Action action, int column) {
        if (action_button(action, column)) act(action);
        tip(with_keys(shortcut_of(action).tip, action).c_str());
    };
    button(Action::open, 0);
    button(Action::save_as, 1);
    if (has_project) button(Action::save_project, 2);
    undo_button(info.undo, Action::undo, 0, act);
    undo_button(info.redo, Action::redo, 1, act);
    button(Action::fit, 2);
}

}  // namespace dapple
