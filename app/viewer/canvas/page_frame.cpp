#include "app/viewer/canvas/page_frame.h"

#include <imgui.h>

#include <cmath>
#include <glm/common.hpp>

#include "app/viewer/widgets/theme.h"

namespace dapple {

void draw_margin_lines(const PageLayout& layout, const Camera& camera, const CanvasPlace& place) {
    const double unit = layout.page.mm_per_page_unit;
    const glm::dvec2 page(layout.page.width_mm, layout.page.height_mm);
    if (!(unit > 0) || layout.within_margins == Rectangle<double>{{0, 0}, page}) return;
    const glm::dvec2 origin = to_canvas(camera, PagePoint(0));
    const auto at = [&](glm::dvec2 mm) {
        const glm::dvec2 pixel = origin + (mm - layout.picture.low) / unit * camera.pixels_per_unit;
        // Far outside, floats and their rounding are of no use.
        const glm::dvec2 point =
            glm::clamp(pixel, glm::dvec2(-1), camera.canvas + 1.0) / place.pixels_per_point;
        return ImVec2(place.corner.x + std::round(static_cast<float>(point.x)),
                      place.corner.y + std::round(static_cast<float>(point.y)));
    };
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const glm::vec2 far = place.corner + place.size;
    list->PushClipRect({place.corner.x, place.corner.y}, {far.x, far.y}, true);
    list->AddRect(at(layout.within_margins.low), at(layout.within_margins.high),
                  (colour_of(ThemeColour::accent) & ~IM_COL32_A_MASK) | 0x90u << IM_COL32_A_SHIFT);
    list->PopClipRect();
}

}  // namespace dapple
