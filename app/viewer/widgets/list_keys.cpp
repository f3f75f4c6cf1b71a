#include "app/viewer/widgets/list_keys.h"

#include <algorithm>
#include <cctype>
#include <cmath>

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

}  // namespace dapple
