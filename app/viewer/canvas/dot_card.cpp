#include "app/viewer/canvas/dot_card.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <vector>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr float kCardReach = 20;   // from the pointer, at 96 dpi
constexpr ImU32 kLitAlpha = 0x38;  // of 255: the dots in the tile are seen through it

ImU32 card_light(ImU32 colour, ImU32 alpha) {
    return (colour & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

/// Below and right of the pointer, or on the other side where there is no room.
ImVec2 corner_beside(ImVec2 pointer, ImVec2 card, const CanvasPlace& place, float air) {
    const glm::vec2 end = place.corner + place.size;
    const bool left = pointer.x + air + card.x > end.x, above = pointer.y + air + card.y > end.y;
    return {std::floor(std::max(left ? pointer.x - air - card.x : pointer.x + air, place.corner.x)),
            std::floor(std::max(above ? pointer.y - air - card.y : pointer.y + air, place.corner.y))};
}

void draw_card_words(ImDrawList* list, const std::vector<std::string>& lines, const CanvasPlace& place,
                     float unit) {
    const float air = 10 * unit, line = ImGui::GetTextLineHeight() + 2 * unit;
    float width = 0;
    for (const std::string& each : lines) width = std::max(width, ImGui::CalcTextSize(each.c_str()).x);
    // The title is bolder than it was measured.
    const ImVec2 card{width + 2.4f * air, line * static_cast<float>(lines.size()) + 1.6f * air};
    const ImVec2 at = corner_beside(ImGui::GetIO().MousePos, card, place, 18 * unit);
    const ImVec2 end{at.x + card.x, at.y + card.y};
    draw_shadow(list, at, end);
    list->AddRectFilled(at, end, colour_of(ThemeColour::panel), 5 * unit);
    float y = at.y + 0.8f * air;
    for (std::size_t i = 0; i < lines.size(); ++i, y += line) {
        if (i == 0) push_title_font();
        list->AddText({at.x + 1.2f * air, y}, colour_of(i == 0 ? ThemeColour::text : ThemeColour::quiet),
                      lines[i].c_str());
        if (i == 0) pop_title_font();
    }
}

}  // namespace

void draw_dot_card(const PlacedDrawing& shown, const PlacedWith& with, const Camera& camera,
                   const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 in_canvas = glm::vec2(io.MousePos.x, io.MousePos.y) - place.corner;
    if (io.WantCaptureMouse || in_canvas.x < 0 || in_canvas.y < 0 || in_canvas.x >= place.size.x ||
        in_canvas.y >= place.size.y)
        return;
    const float unit = ImGui::GetFontSize() / 15;
    const double pixels_per_point = place.pixels_per_point.x;
    const double reach =
        std::max(kCardReach * unit * pixels_per_point / camera.pixels_per_unit, shown.dot_radius);
    const PagePoint pointer = point_at(camera, glm::dvec2(in_canvas) * place.pixels_per_point);
    const auto dot = dot_under(shown, with, pointer, reach);
    if (!dot) return;
    const auto on_screen = [&](glm::dvec2 in_window) {
        const PagePoint corner(shown.window.x, shown.window.y);
        const glm::dvec2 pixel = to_canvas(camera, corner + PagePoint(in_window * 0x1p62));
        // Far outside, floats and their rounding are of no use.
        const glm::dvec2 at = glm::clamp(pixel, glm::dvec2(-9), camera.canvas + 9.0) / place.pixels_per_point;
        return ImVec2(place.corner.x + static_cast<float>(at.x), place.corner.y + static_cast<float>(at.y));
    };
    ImDrawList* const list = ImGui::GetForegroundDrawList();
    list->PushClipRect({place.corner.x, place.corner.y},
                       {place.corner.x + place.size.x, place.corner.y + place.size.y});
    const ImU32 light = colour_of(ThemeColour::accent);
    if (const auto& tile = dot->tile) {
        const ImVec2 low = on_screen({tile->x, tile->y});
        const ImVec2 high = on_screen(glm::dvec2(tile->x, tile->y) + tile->side);
        list->AddRectFilled(low, high, card_light(light, kLitAlpha));
        list->AddRect(low, high, light, 0, 0, 1.5f * unit);
        note_place("Lit tile", {{low.x, low.y}, {high.x, high.y}});
    }
    // Zoomed in far the ring is beyond all edges, and further in Dear ImGui cannot count its sides.
    const double radius = shown.dot_radius * camera.pixels_per_unit / pixels_per_point;
    if (radius < double{place.size.x} + double{place.size.y})
        list->AddCircle(on_screen(dot->position), static_cast<float>(radius) + 3 * unit, light, 0, 2 * unit);
    draw_card_words(list, origin_in_words(*dot, with, shown.scale), place, unit);
    list->PopClipRect();
}

}  // namespace dapple
