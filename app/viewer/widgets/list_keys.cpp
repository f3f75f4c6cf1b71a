#include "app/viewer/widgets/list_keys.h"

#include <algorithm>
#include <cmath>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

void ListKeys::begin(const char* name, ImVec2 low, ImVec2 high) {
    keys_ = row_keys(name, low, high);
    const int entries = drawn_;  // in the last frame
    const int step = static_cast<int>(std::copysign(std::ceil(std::abs(keys_.step)), keys_.step));
    marked_ = std::clamp(marked_ - step, 0, std::max(entries - 1, 0));
    drawn_ = 0;
}

RowKeys ListKeys::end_entry() {
    const bool marked = next_is_marked();
    ++drawn_;
    if (!marked) return {};
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, colour_of(ThemeColour::accent), 0, 0,
                                        ImGui::GetTextLineHeight() / 15);
    note_place(kMarkedEntry);
    if (keys_.step != 0) ImGui::SetScrollHereY();
    return keys_;
}

}  // namespace dapple
