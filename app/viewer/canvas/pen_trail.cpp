#include "app/viewer/canvas/pen_trail.h"

#include <imgui.h>

#include <cstddef>

#include "app/viewer/widgets/theme.h"

namespace dapple {

void draw_pen_trail(std::span<const glm::dvec2> places, const Camera& camera, const CanvasPlace& place) {
    if (places.empty()) return;
    const auto at = [&](glm::dvec2 page_units) {
        const glm::dvec2 point = to_canvas(camera, page_point(page_units)) / place.pixels_per_point;
        return ImVec2(place.corner.x + static_cast<float>(point.x),
                      place.corner.y + static_cast<float>(point.y));
    };
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const glm::vec2 far = place.corner + place.size;
    list->PushClipRect({place.corner.x, place.corner.y}, {far.x, far.y}, true);
    const float unit = ImGui::GetFontSize() / 15;
    const ImU32 colour = colour_of(ThemeColour::accent) & ~IM_COL32_A_MASK;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto opacity = static_cast<ImU32>(255 * i / places.size());
        list->AddLine(at(places[i - 1]), at(places[i]), colour | opacity << IM_COL32_A_SHIFT, 1.5f * unit);
    }
    list->AddCircle(at(places.back()), 7 * unit, colour | 255u << IM_COL32_A_SHIFT, 0, 2 * unit);
    list->PopClipRect();
}

}  // namespace dapple
