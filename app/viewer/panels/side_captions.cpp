#include "app/viewer/panels/side_captions.h"

#include <imgui.h>

#include <cmath>

#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

constexpr std::size_t kFactLines = 2;

// As much of a line in the font in use as fits.
std::string fitting(std::string line, float width) {
    if (ImGui::CalcTextSize(line.c_str()).x <= width) return line;
    while (!line.empty() && ImGui::CalcTextSize((line + "...").c_str()).x > width) line.pop_back();
    return line + "...";
}

void draw_caption(const SideCaption& caption, float left, float right, float top, float height) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const float air = ImGui::GetFontSize() * 0.7f, room = right - left - 2 * air;
    if (room <= 0) return;
    float y = std::floor(top + (height - (1 + kFactLines) * ImGui::GetTextLineHeight()) / 2);
    const auto draw_line = [&](const std::string& line, ThemeColour colour) {
        const std::string shown = fitting(line, room);
        const float x = std::floor((left + right - ImGui::CalcTextSize(shown.c_str()).x) / 2);
        list->AddText({x, y}, colour_of(colour), shown.c_str());
        y += ImGui::GetTextLineHeight();
    };
    push_title_font();
    draw_line(caption.title, ThemeColour::text);
    pop_title_font();
    for (const std::string& fact : caption.info) draw_line(fact, ThemeColour::quiet);
}

}  // namespace

float side_captions_height() {
    return std::round(ImGui::GetFontSize() * (2.2f + kFactLines));
}

void draw_side_captions(const std::array<SideCaption, 2>& captions, float share, glm::vec2 corner,
                        glm::vec2 size) {
    const float middle = corner.x + size.x * share, right = corner.x + size.x;
    ImGui::GetBackgroundDrawList()->AddRectFilled({corner.x, corner.y}, {right, corner.y + size.y},
                                                  colour_of(ThemeColour::surround));
    draw_caption(captions[0], corner.x, middle, corner.y, size.y);
    draw_caption(captions[1], middle, right, corner.y, size.y);
}

}  // namespace dapple
