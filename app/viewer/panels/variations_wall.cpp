#include "app/viewer/panels/window_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

std::optional<std::size_t> draw_variations(const std::array<Variation, 9>& variations,
                                           const std::function<EntryPicture(const DrawingSettings&)>& preview,
                                           glm::vec2 corner, glm::vec2 size) {
    constexpr std::size_t kMiddle = 4, kARow = 3;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetColorU32(colour_of(ThemeColour::surround)));
    begin_bare("##variations", {corner.x, corner.y}, {size.x, size.y},
               ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 room = ImGui::GetContentRegionAvail(), first = ImGui::GetCursorScreenPos();
    const float width = std::floor(room.x / kARow), height = std::floor((room.y - 1.5f * line) / kARow);
    // In lines of text, as boxes of entries are; the name stands below.
    const EntryBox box{std::max(width - line, line) / line, std::max(height - 2 * line, line) / line};
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < variations.size(); ++i) {
        const auto column = static_cast<float>(i % kARow), row = static_cast<float>(i / kARow);
        ImGui::SetCursorScreenPos({first.x + column * width, first.y + row * height});
        const std::string name = variations[i].name;
        if (strip_entry("Variation " + name, name, i == kMiddle, preview(variations[i].drawing), box))
            clicked = i;
    }
    ImGui::SetCursorScreenPos({first.x, first.y + kARow * height});
    hint("Click one to use it; the middle one or Escape returns to the drawing.");
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    return clicked;
}

}  // namespace dapple
