#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/theme.h"
#include "io/files/tile_library.h"

namespace dapple {
namespace {

constexpr std::size_t kFactLines = 2;

// As much of a line in the font in use as fits.
std::string fitting(std::string line, float width) {
    if (ImGui::CalcTextSize(line.c_str()).x <= width) return line;
    while (!line.empty() && ImGui::CalcTextSize((line + "...").c_str()).x > width) line.pop_back();
    return line + "...";
}

void draw_caption(const ComparedPanes& compared, const Pane& pane, float left, float right, float top,
                  float height) {
    const float air = ImGui::GetFontSize() * 0.7f, room = right - left - 2 * air;
    if (room <= 0) return;
    float y = std::floor(top + (height - (1 + kFactLines) * ImGui::GetTextLineHeight()) / 2);
    const auto draw_line = [&](const std::string& line, ThemeColour colour) {
        const std::string shown = fitting(line, room);
        const float x = std::floor((left + right - ImGui::CalcTextSize(shown.c_str()).x) / 2);
        ImGui::GetBackgroundDrawList()->AddText({x, y}, colour_of(colour), shown.c_str());
        y += ImGui::GetTextLineHeight();
    };
    const DotsRequest request = pane.page().request.value_or(DotsRequest{});
    const bool is_saved = &pane == &compared.session().pane();
    const bool figure8 = request.drawing.placer == PlacerKind::figure8;
    push_title_font();
    draw_line(fmt::format("{}{}{}", short_tile_name(request.drawing.tile), figure8 ? ", Figure 8" : "",
                          is_saved ? " (exported)" : ""),
              ThemeColour::text);
    pop_title_font();
    draw_line(
        dots_in_words(
            {.dots = pane.page().dots.size(), .duplicates = pane.page().duplicates, .figure8 = figure8}),
        ThemeColour::quiet);
    if (const auto value = compared.periodicity(pane))
        draw_line(fmt::format("periodicity over {}-point tiles {:.2f}", compared.tile_size(),
                              std::clamp(*value, 0.0, 1.0)),
                  ThemeColour::quiet);
}

}  // namespace

float side_captions_height() {
    return std::round(ImGui::GetFontSize() * (2.2f + kFactLines));
}

void draw_side_captions(const ComparedPanes& compared, glm::vec2 corner, glm::vec2 size) {
    const Pane* const right_pane = compared.right();
    if (!right_pane) return;
    const float share = compared.session().settings.comparison.divider;
    const float middle = corner.x + size.x * share, right = corner.x + size.x;
    ImGui::GetBackgroundDrawList()->AddRectFilled({corner.x, corner.y}, {right, corner.y + size.y},
                                                  colour_of(ThemeColour::surround));
    draw_caption(compared, compared.seen(), corner.x, middle, corner.y, size.y);
    draw_caption(compared, *right_pane, middle, right, corner.y, size.y);
}

}  // namespace dapple
