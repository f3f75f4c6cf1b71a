#include "app/viewer/canvas/mask_painter.h"

#include <imgui.h>

#include <algorithm>
#include <glm/vector_relational.hpp>

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

// In ImGui's points.
ImVec2 screen_point(const Camera& camera, const CanvasPlace& place, glm::dvec2 page_units) {
    const glm::dvec2 at = to_canvas(camera, page_point(page_units)) / place.pixels_per_point;
    return {place.corner.x + static_cast<float>(at.x), place.corner.y + static_cast<float>(at.y)};
}

bool pointer_over(const CanvasPlace& place) {
    const glm::vec2 pointer{ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y};
    return glm::all(glm::greaterThanEqual(pointer, place.corner)) &&
           glm::all(glm::lessThan(pointer, place.corner + place.size));
}

PagePoint page_point_under(ImVec2 screen, const Camera& camera, const CanvasPlace& place) {
    return point_at(
        camera, glm::dvec2(screen.x - place.corner.x, screen.y - place.corner.y) * place.pixels_per_point);
}

}  // namespace

glm::dvec2 opened_point(const Framing& framing, glm::ivec2 picture, PagePoint point) {
    const glm::dvec2 framed = in_page_units(point) * longer_of(framing.size());
    return opened_pixel(framing, framed) / longer_of(picture);
}

double page_units_per_unit(const Framing& framing, glm::ivec2 picture) {
    return longer_of(picture) / longer_of(framing.size());
}

bool MaskPainter::paint(Mask& mask, const MaskBrush& tool, const PlacedDrawing& shown, const Camera& camera,
                        const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 press = io.MouseClickedPos[ImGuiMouseButton_Left];
    const auto point = [&](ImVec2 screen) {
        return opened_point(shown.plan.framing, shown.plan.opened, page_point_under(screen, camera, place));
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
        if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.WantCaptureMouse || !pointer_over(place))
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
    const glm::vec2 far = place.corner + place.size;
    list->PushClipRect({place.corner.x, place.corner.y}, {far.x, far.y}, true);
    if (!mask.empty()) {
        if (tinted_ != mask) tint_.write(tint_of(mask));
        tinted_ = mask;
        const PictureView view = view_of(shown.plan.framing, shown.plan.opened);
        const glm::vec2 x = view.corner + view.across, y = view.corner + view.down, xy = x + view.down;
        const glm::dvec2 size = shown.plan.picture_size();
        list->AddImageQuad(texture_id(tint_.get()), screen_point(camera, place, {0, 0}),
                           screen_point(camera, place, {size.x, 0}), screen_point(camera, place, size),
                           screen_point(camera, place, {0, size.y}), {view.corner.x, view.corner.y},
                           {x.x, x.y}, {xy.x, xy.y}, {y.x, y.y});
    }
    if (stroke_ || (!ImGui::GetIO().WantCaptureMouse && pointer_over(place))) {
        const double units = tool.brush.radius * page_units_per_unit(shown.plan.framing, shown.plan.opened);
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
