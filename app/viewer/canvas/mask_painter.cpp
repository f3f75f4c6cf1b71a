#include "app/viewer/canvas/mask_painter.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/canvas/pane_view.h"
#include "app/viewer/widgets/keys.h"

namespace dapple {
namespace {

constexpr double kMostTint = 110;  // of 255: the dots are seen through it

double longer_of(glm::ivec2 size) {
    return std::max({size.x, size.y, 1});
}

glm::dvec4 tint_of_level(std::uint8_t level) {
    const double share = level < kNeutralLevel ? double(kNeutralLevel - level) / kNeutralLevel
                                               : double(level - kNeutralLevel) / (255 - kNeutralLevel);
    return level < kNeutralLevel ? glm::dvec4(220, 40, 40, kMostTint * share)
                                 : glm::dvec4(40, 90, 230, kMostTint * share);
}

// A colour of that alpha, 0..255, over another.
glm::dvec4 over(glm::dvec4 upper, glm::dvec4 lower) {
    const double seen = lower.a * (1 - upper.a / 255), alpha = upper.a + seen;
    if (alpha == 0) return lower;
    return {(glm::dvec3(upper) * upper.a + glm::dvec3(lower) * seen) / alpha, alpha};
}

Grid<glm::u8vec4> tint_of(const Mask& mask) {
    const Grid<std::uint8_t>& levels = mask.levels();
    Grid<glm::u8vec4> picture(levels.width, levels.height);
    std::ranges::transform(levels.values, picture.values.begin(),
                           [](std::uint8_t level) { return glm::u8vec4(tint_of_level(level)); });
    if (!mask.has_finer()) return picture;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const glm::dvec4 finer(30, 170, 60, kMostTint * mask.fineness().values[i] / 255);
        picture.values[i] = glm::u8vec4(over(finer, tint_of_level(levels.values[i])));
    }
    return picture;
}

// Where on the picture as it was opened a point of the page lies, in units of that picture's longer side.
glm::dvec2 opened_point(const Framing& framing, glm::ivec2 picture, PagePoint point) {
    const glm::dvec2 framed = in_page_units(point) * longer_of(framing.size());
    return opened_pixel(framing, framed) / longer_of(picture);
}

}  // namespace

bool MaskPainter::paint(Mask& mask, const MaskBrush& tool, const PlacedDrawing& shown, const Camera& camera,
                        const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 press = io.MouseClickedPos[ImGuiMouseButton_Left];
    const auto point = [&](ImVec2 screen) {
        return opened_point(shown.plan.framing, shown.plan.opened, place.page_at(screen, camera));
    };
    if (!tool.on || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        // Where frames are slow, the last of the way and letting go may be in one.
        if (stroke_ && tool.on) {
            stroke_->go_to(point(io.MousePos));
            mask = stroke_->mask();
        }
        stroke_.reset();
        return false;
    }
    if (!stroke_) {
        if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.WantCaptureMouse || !place.holds(io.MousePos))
            return false;
        stroke_.emplace(mask, shown.plan.opened, tool.brush);
        stroke_->go_to(point(press));
    } else if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) {
        return true;
    }
    stroke_->go_to(point(io.MousePos));
    mask = stroke_->mask();
    return true;
}

void MaskPainter::draw(const Mask& mask, const MaskBrush& tool, const PlacedDrawing& shown,
                       const Camera& camera, const CanvasPlace& place) {
    if (!tool.on) return;
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    place.clip(list);
    if (!mask.empty()) {
        if (tinted_ != mask) tint_.write(tint_of(mask));
        tinted_ = mask;
        const PictureView view = view_of(shown.plan.framing, shown.plan.opened);
        const glm::vec2 x = view.corner + view.across, y = view.corner + view.down, xy = x + view.down;
        const glm::dvec2 size = shown.plan.picture_size();
        const auto at = [&](glm::dvec2 page_units) {
            return place.point_of(to_canvas(camera, page_point(page_units)));
        };
        list->AddImageQuad(texture_id(tint_.get()), at({0, 0}), at({size.x, 0}), at(size), at({0, size.y}),
                           {view.corner.x, view.corner.y}, {x.x, x.y}, {xy.x, xy.y}, {y.x, y.y});
    }
    if (stroke_ || (!ImGui::GetIO().WantCaptureMouse && place.holds(ImGui::GetIO().MousePos))) {
        const double units =
            tool.brush.radius * (longer_of(shown.plan.opened) / longer_of(shown.plan.framing.size()));
        const auto radius = static_cast<float>(units * camera.pixels_per_unit / place.pixels_per_point.x);
        const ImVec2 centre = ImGui::GetIO().MousePos;
        const float unit = ImGui::GetFontSize() / 15;
        // Dark and light, so that it is seen on any ground.
        list->AddCircle(centre, radius + unit, IM_COL32(0, 0, 0, 160), 96, unit);
        list->AddCircle(centre, radius, IM_COL32(255, 255, 255, 230), 96, unit);
        const auto inner = static_cast<float>(radius * (1 - tool.brush.softness));
        if (inner > 2 * unit) list->AddCircle(centre, inner, IM_COL32(128, 128, 128, 160), 96, unit);
    }
    list->PopClipRect();
}

}  // namespace dapple
