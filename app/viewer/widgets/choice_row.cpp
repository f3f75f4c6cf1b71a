#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

constexpr float kSegmentAir = 0.9f;  // in letters' heights, between two words side by side
constexpr float kLeastSegmentAir = 0.3f, kLeastLabel = 3;

}  // namespace

bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                int usual) {
    return choice_row(label, chosen, names, tip,
                      ListLook{.by_arrows = static_cast<int>(names.size()), .usual = usual});
}

namespace {

/// The entries of an open list, the mark walked by arrows. Which one was taken; none: the list stays open.
std::optional<int> draw_list(int marked_at_first, std::span<const char* const> names, const ListLook& look) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID mark = ImGui::GetID("marked");
    const auto entries = static_cast<int>(names.size());
    const int walked = step_between(Key::up, Key::down);
    if (ImGui::IsWindowAppearing()) storage->SetInt(mark, marked_at_first);
    const int marked = std::clamp(storage->GetInt(mark) + walked, 0, std::max(entries - 1, 0));
    storage->SetInt(mark, marked);
    std::optional<int> taken;
    for (int i = 0; i < entries; ++i) {
        const char* const name = names[static_cast<std::size_t>(i)];
        const bool clicked = look.draw ? look.draw(i, i == marked) : ImGui::Selectable(name, i == marked);
        if (!look.draw) note_place(name);
        if (clicked) taken = i;
        if (i == marked && (walked != 0 || ImGui::IsWindowAppearing())) ImGui::SetScrollHereY();
    }
    if (enter_pressed()) taken = marked;
    if (taken) ImGui::CloseCurrentPopup();
    take_keyboard();
    return taken;
}

/// Opens the list of the combo box drawn last, as a click on it does.
void open_list(const char* combo) {
    ImGui::PushID(combo);
    const ImGuiID list = ImGui::GetID("##ComboPopup");
    ImGui::PopID();
    ImGui::OpenPopup(list);
}

}  // namespace

bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                const ListLook& look) {
    constexpr char kCombo[] = "##choice";
    const auto values = static_cast<std::size_t>(look.by_arrows);
    if (const auto listed = as_listed(label, names.first(std::min(values, names.size())), chosen))
        return *listed;
    Row row;
    const int before = chosen;
    const bool reset = begin_row(label, row);
    ImGui::SetNextItemWidth(row.start.x + row.width - row.control_x);
    bool valid = chosen >= 0 && chosen < static_cast<int>(names.size());
    if (look.lines_wide > 0) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowSizeConstraints(
            {std::min(look.lines_wide * ImGui::GetTextLineHeight(), screen.x), 0}, {screen.x, screen.y});
    }
    const bool open = ImGui::BeginCombo(kCombo, valid ? names[static_cast<std::size_t>(chosen)] : "",
                                        ImGuiComboFlags_HeightLarge);
    if (!open) note_place(label);
    if (open) {
        chosen = draw_list(chosen, names, look).value_or(chosen);
        close_on_escape();
        ImGui::EndCombo();
        note_place(label,
                   {{row.control_x, row.start.y}, {row.start.x + row.width, row.start.y + row.height}});
    }
    const RowKeys keys = keys_of(label, row);
    if (!open && (keys.press || (keys.step != 0 && look.by_arrows == 0))) open_list(kCombo);
    // As in other programs' lists, the arrows choose without opening it.
    if (look.by_arrows > 0) chosen = stepped(chosen, -keys.step, static_cast<std::size_t>(look.by_arrows));
    if ((reset || keys.reset) && look.usual >= 0) chosen = look.usual;
    if (!open) show_row_tip(tip, row);
    end_row(row);
    return chosen != before;
}

namespace {

/// Where each of some words side by side ends: all have the same air around them.
std::vector<float> segment_ends(float left, float right, std::span<const char* const> names) {
    float words = 0;
    for (const char* const name : names) words += ImGui::CalcTextSize(name).x;
    const auto count = static_cast<float>(names.size());
    const float air = (right - left - words) / count;
    std::vector<float> ends;
    float x = left;
    for (const char* const name : names) {
        // Where there is no room even for the words, all are cut alike.
        x += air > 0 ? ImGui::CalcTextSize(name).x + air : (right - left) / count;
        ends.push_back(std::floor(x + 0.5f));
    }
    return ends;
}

/// Whether the words fit into a row beside one another, if its label takes no more than its first letters.
bool have_room(std::span<const char* const> names) {
    const float line = ImGui::GetTextLineHeight();
    float words = 0;
    for (const char* const name : names) words += ImGui::CalcTextSize(name).x + kLeastSegmentAir * line;
    return words <= ImGui::GetContentRegionAvail().x - kLeastLabel * line;
}

/// How wide the control is: words that need more room than the labels' column leaves get what its label does
/// not need.
float segments_width(const char* label, std::span<const char* const> names) {
    const float line = ImGui::GetTextLineHeight(), row = ImGui::GetContentRegionAvail().x;
    float wanted = 0;
    for (const char* const name : names) wanted += ImGui::CalcTextSize(name).x + kSegmentAir * line;
    const float usual = row - std::floor(row * kLabelShare);
    const float most = row - std::ceil(ImGui::CalcTextSize(label).x) - std::floor(kLabelAir * line);
    return std::floor(std::clamp(wanted, usual, std::max(most, usual)));
}

}  // namespace

bool segmented_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                   int usual) {
    if (const auto listed = as_listed(label, names, chosen)) return *listed;
    if (!have_room(names)) return choice_row(label, chosen, names, tip, usual);
    Row row;
    const int before = chosen;
    const float width = segments_width(label, names);
    if (begin_row(label, row, {.control_width = width})) chosen = usual;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float left = row.start.x + row.width - width;
    float right = row.start.x + row.width, bottom = row.start.y + row.height;
    float rounding = ImGui::GetStyle().FrameRounding;
    const float pixel = ImGui::GetTextLineHeight() / 15;
    const bool greyed = ImGui::GetStyle().Alpha < 1;
    list->AddRectFilled({left, row.start.y}, {right, bottom}, colour_of(ThemeColour::track), rounding);
    const std::vector<float> ends = segment_ends(left, right, names);
    float x0 = left;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        const char* const name = names[static_cast<std::size_t>(i)];
        const float x1 = ends[static_cast<std::size_t>(i)];
        ImGui::SetCursorScreenPos({x0, row.start.y});
        if (press_area(name, {x1 - x0, row.height})) chosen = i;
        note_place(name);
        const bool on = chosen == i;
        // A greyed one is a tint under the word: pale letters on a pale colour could not be read.
        if (on)
            list->AddRectFilled(
                {x0 + 2 * pixel, row.start.y + 2 * pixel}, {x1 - 2 * pixel, bottom - 2 * pixel},
                greyed ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : colour_of(ThemeColour::accent),
                rounding);
        const ImVec2 size = ImGui::CalcTextSize(name);
        const bool strong = on || ImGui::IsItemHovered();
        const auto colour = on && !greyed
                                ? colour_of(ThemeColour::panel)
                                : ImGui::GetColorU32(strong ? ImGuiCol_Text : ImGuiCol_TextDisabled);
        const float inset = std::max(pixel, (x1 - x0 - size.x) / 2);
        list->PushClipRect({x0 + pixel, row.start.y}, {x1 - pixel, bottom}, true);
        list->AddText({std::floor(x0 + inset), row.start.y + (row.height - size.y) / 2}, colour, name);
        list->PopClipRect();
        x0 = x1;
    }
    const RowKeys keys = keys_of(label, row);
    chosen = keys.reset ? usual : stepped(chosen, keys.step, names.size());
    show_row_tip(tip, row);
    end_row(row);
    return chosen != before;
}

}  // namespace dapple
