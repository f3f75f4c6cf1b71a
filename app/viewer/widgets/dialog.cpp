#include "app/viewer/widgets/dialog.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

void ListKeys::begin(const char* name, ImVec2 low, ImVec2 high) {
    keys_ = row_keys(name, low, high);
    const int entries = drawn_;  // in the last frame
    const int step = static_cast<int>(std::copysign(std::ceil(std::abs(keys_.step)), keys_.step));
    const std::optional<int> found = after_ ? after_ : first_;
    moved_ = step != 0 || found;
    marked_ = found.value_or(marked_);
    first_ = after_ = {};
    const auto& typed = ImGui::GetIO().InputQueueCharacters;
    letter_ =
        keys_.focused && !typed.empty() && typed[0] < 128 ? std::tolower(static_cast<int>(typed[0])) : 0;
    marked_ = std::clamp(marked_ - step, 0, std::max(entries - 1, 0));
    drawn_ = 0;
}

RowKeys ListKeys::end_entry(std::string_view name) {
    const bool marked = next_is_marked();
    if (letter_ != 0 && !name.empty() && std::tolower(static_cast<unsigned char>(name[0])) == letter_) {
        if (!first_) first_ = drawn_;
        if (!after_ && drawn_ > marked_) after_ = drawn_;
    }
    ++drawn_;
    if (!marked) return {};
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, colour_of(ThemeColour::accent), 0, 0,
                                        ImGui::GetTextLineHeight() / 15);
    note_place(kMarkedEntry);
    if (moved_) ImGui::SetScrollHereY();
    return keys_;
}

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
