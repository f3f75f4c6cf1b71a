#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr int kButtonsARow = 3;

/// Draws with lines of that colour around a place; so large is half of it.
using DrawIcon = void (*)(ImDrawList& list, ImVec2 middle, float half, ImU32 colour);

// Three short lines, as menus are known by.
void draw_menu_icon(ImDrawList& list, ImVec2 middle, float half, ImU32 colour) {
    const float thick = half / 4.5f;
    for (const float line : {-0.7f, 0.0f, 0.7f})
        list.AddLine({middle.x - half, middle.y + line * half}, {middle.x + half, middle.y + line * half},
                     colour, thick);
}

// An arrow that turns back; `side` -1 to the left, 1 to the right.
void draw_turn(ImDrawList& list, ImVec2 middle, float half, ImU32 colour, float side) {
    const float thick = half / 4.5f, radius = 0.62f * half, arm = 0.5f * half;
    const ImVec2 tip{middle.x + side * half, middle.y - 0.38f * half};
    constexpr float kQuarter = 1.5707963f;
    list.PathLineTo(tip);
    list.PathLineTo({middle.x - side * 0.2f * half, tip.y});
    const ImVec2 centre{middle.x - side * 0.2f * half, tip.y + radius};
    list.PathArcTo(centre, radius, -kQuarter, side > 0 ? -3 * kQuarter : kQuarter, 12);
    list.PathLineTo({middle.x + side * 0.45f * half, tip.y + 2 * radius});
    list.PathStroke(colour, 0, thick);
    const ImVec2 head[] = {{tip.x - side * arm, tip.y - arm}, tip, {tip.x - side * arm, tip.y + arm}};
    list.AddPolyline(head, 3, colour, 0, thick);
}
void draw_undo_icon(ImDrawList& list, ImVec2 middle, float half, ImU32 colour) {
    draw_turn(list, middle, half, colour, -1);
}
void draw_redo_icon(ImDrawList& list, ImVec2 middle, float half, ImU32 colour) {
    draw_turn(list, middle, half, colour, 1);
}

// The corners of a frame.
void draw_fit_icon(ImDrawList& list, ImVec2 middle, float half, ImU32 colour) {
    const float arm = 0.6f * half;
    for (const float x : {-1.0f, 1.0f}) {
        for (const float y : {-1.0f, 1.0f}) {
            const ImVec2 corner{middle.x + x * 0.9f * half, middle.y + y * 0.75f * half};
            const ImVec2 line[] = {{corner.x - x * arm, corner.y}, corner, {corner.x, corner.y - y * arm}};
            list.AddPolyline(line, 3, colour, 0, half / 4.5f);
        }
    }
}

bool icon_button(const char* label, DrawIcon draw, const char* about) {
    const ImVec2 size{std::floor(ImGui::GetFrameHeight() * 1.1f), ImGui::GetFrameHeight()};
    const bool pressed = press_area(label, size);
    note_place(label);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool hot = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hot)
        list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_ButtonHovered),
                           ImGui::GetStyle().FrameRounding);
    const ImVec2 middle{std::floor((low.x + high.x) / 2), std::floor((low.y + high.y) / 2)};
    draw(list, middle, 6.5f * ImGui::GetTextLineHeight() / 15,
         colour_of(hot ? ThemeColour::text : ThemeColour::quiet));
    if (about) tip(about);
    return item_keys(label).press || pressed;
}

constexpr Action kCanvasMenu[] = {Action::fit,       Action::one_to_one,   Action::photograph,
                                  Action::as_it_was, Action::copy_picture, Action::save_as};
constexpr Action kMenu[] = {Action::palette, Action::help, Action::full_screen, Action::preferences,
                            Action::about};

// What was chosen, which is done once the menu is closed.
std::optional<Action> draw_menu(const char* name, std::span<const Action> entries) {
    if (!ImGui::BeginPopup(name)) return std::nullopt;
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID mark = ImGui::GetID("marked");
    const auto last = static_cast<int>(entries.size()) - 1;
    if (ImGui::IsWindowAppearing()) storage->SetInt(mark, -1);
    const int walked = step_between(Key::up, Key::down);
    const int marked =
        walked == 0 ? storage->GetInt(mark) : std::clamp(storage->GetInt(mark) + walked, 0, last);
    storage->SetInt(mark, marked);
    std::optional<Action> chosen;
    for (int i = 0; i <= last; ++i) {
        const Action action = entries[static_cast<std::size_t>(i)];
        const Shortcut& entry = shortcut_of(action);
        const bool entered = i == marked && enter_pressed();
        if (ImGui::MenuItem(entry.label, entry.keys, i == marked) || entered) chosen = action;
        note_place(entry.label);
    }
    if (chosen || key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
    take_keyboard();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace

void draw_title(const std::string& name, const UndoInfo& info, const std::function<void(Action)>& act) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float button = std::floor(ImGui::GetFrameHeight() * 1.1f), height = ImGui::GetFrameHeight();
    const float icons = 4 * button, air = (height - ImGui::GetTextLineHeight()) / 2;
    push_title_font();
    ImGui::PushClipRect(start, {start.x + std::max(width - icons - air, 1.0f), start.y + height}, true);
    ImGui::SetCursorScreenPos({start.x, start.y + air});
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopClipRect();
    pop_title_font();
    ImVec2 place{start.x + std::max(width - icons, 0.0f), start.y};
    const auto icon = [&](const char* label, DrawIcon draw, const char* about) {
        ImGui::SetCursorScreenPos(place);
        place.x += button;
        return icon_button(label, draw, about);
    };
    const auto undo = [&](const std::optional<std::string>& words, Action action, DrawIcon draw) {
        const char* const label = shortcut_of(action).label;
        const std::string about =
            words
                ? with_keys(fmt::format("{}: {}", label, words->empty() ? "the last change" : *words), action)
                : "";
        if (!words) ImGui::BeginDisabled();
        if (icon(label, draw, words ? about.c_str() : nullptr)) act(action);
        if (!words) ImGui::EndDisabled();
    };
    undo(info.undo, Action::undo, draw_undo_icon);
    undo(info.redo, Action::redo, draw_redo_icon);
    const Shortcut& fit = shortcut_of(Action::fit);
    if (icon(fit.label, draw_fit_icon, with_keys(fit.tip, Action::fit).c_str())) act(Action::fit);
    const float right = place.x + button;
    if (icon("Menu", draw_menu_icon, "All commands, keys, preferences and about Dapple."))
        ImGui::OpenPopup("menu");
    ImGui::SetNextWindowPos({right, start.y + height + ImGui::GetStyle().ItemSpacing.y}, ImGuiCond_Always,
                            {1, 0});
    if (const std::optional<Action> chosen = draw_menu("menu", kMenu)) act(*chosen);
    go_on_at({start.x, start.y + height});
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

bool draw_canvas_tools(glm::vec2 corner, Column column, const std::function<void(Action)>& act) {
    constexpr std::pair<Action, Column> kTools[] = {{Action::crop, Column::crop},
                                                    {Action::mask, Column::mask},
                                                    {Action::retouch, Column::retouch},
                                                    {Action::rotate, Column::drawing}};
    const float air = 10 * ImGui::GetTextLineHeight() / 15;
    ImGui::SetNextWindowPos({corner.x + air, corner.y + air});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {air / 2.5f, air / 2.5f});
    ImGui::Begin("##tools", nullptr,
                 kNeverAsksForFocus | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    for (const auto& [action, its_column] : kTools) {
        const Shortcut& tool = shortcut_of(action);
        if (action != kTools[0].first) ImGui::SameLine();
        const bool marked = its_column == column && column != Column::drawing;
        if (marked) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
        if (ImGui::Button(tool.label)) act(action);
        if (marked) ImGui::PopStyleColor();
        note_place(tool.label);
        tip(with_keys(tool.tip, action).c_str());
    }
    ImGui::SameLine();
    ImGui::Button("Compare");
    const bool held = ImGui::IsItemActive();
    note_place("Hold to compare");
    tip("Hold to see the photograph.   C");
    ImGui::End();
    ImGui::PopStyleVar();
    return held;
}

void draw_action_buttons(bool has_project, const std::function<void(Action)>& act) {
    const float air = ImGui::GetStyle().ItemSpacing.x;
    // The width of the whole row, wherever in it the cursor is.
    const float row = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const auto button = [&](Action action, int column) {
        const Shortcut& shortcut = shortcut_of(action);
        if (column > 0) ImGui::SameLine();
        const bool pressed = key_button(shortcut.label, {(row - (kButtonsARow - 1) * air) / kButtonsARow, 0});
        note_place(shortcut.label);
        if (pressed) act(action);
        tip(with_keys(shortcut.tip, action).c_str());
    };
    button(Action::open, 0);
    button(Action::save_as, 1);
    if (has_project) button(Action::save_project, 2);
}

}  // namespace dapple
