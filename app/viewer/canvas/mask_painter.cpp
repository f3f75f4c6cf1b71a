#include "app/viewer/canvas/mask_painter.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "app/viewer/canvas/pane_view.h"
#include "app/viewer/widgets/keys.h"

namespace dapple {
namespace {

constexpr double kMostTint = 110;  // of 255: the dots are seen through it

// In ImGui's points at 96 dpi: how far a click reaches, and from point to point of a way.
constexpr double kReach = 12, kStep = 2;
constexpr float kSmallestMm = 0.01f;

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

// The one that is nearest to a place, further away than that and within a reach, as if it had been added.
std::optional<Edit> dot_near(const PlacedDrawing& shown, glm::vec2 at_mm, double from_mm, double reach_mm) {
    const double unit = shown.layout.page.mm_per_page_unit, usual = shown.dot_radius();
    const glm::dvec2 corner = shown.layout.picture.low, at = (glm::dvec2(at_mm) - corner) / unit;
    std::optional<Edit> nearest;
    for (const Dots& piece : shown.dots.pieces) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const glm::dvec2 place(piece.x[i], piece.y[i]);
            const double distance = glm::distance(place, at) * unit;
            if (distance < from_mm || distance > reach_mm) continue;
            reach_mm = distance;
            nearest = {Edit::Kind::dot, {glm::vec2(corner + place * unit)}, 0, piece.pen};
            if (const float own = piece.radius.empty() ? 0 : piece.radius[i];
                std::abs(own - usual) > 1e-4 * usual)
                nearest->radius_mm = static_cast<float>(own * unit);
        }
    }
    return nearest;
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

std::string Retoucher::edits_made(const RetouchTool& tool, const PlacedDrawing& shown,
                                  float resized_mm) const {
    const Hand hand = tool.hand;
    constexpr double kAnywhere = std::numeric_limits<double>::max();
    if (hand == Hand::whiten) return text_of({Edit::Kind::bare, way_, static_cast<float>(tool.brush_mm)});
    if (hand == Hand::lasso) return way_.size() < 3 ? "" : text_of({Edit::Kind::bare, way_});
    if (hand == Hand::add) {  // of the pen that draws beside it
        const auto beside = dot_near(shown, way_.back(), 0, kAnywhere);
        return text_of({Edit::Kind::dot, {way_.back()}, 0, beside ? beside->pen : 0});
    }
    if (!dot_ || (hand != Hand::remove && way_.size() < 2)) return "";
    // What the dot covers gets bare, and not the middle of another.
    const glm::vec2 at = dot_->points[0];
    const double tiny = 1e-6 * shown.layout.page.mm_per_page_unit;
    float bare = dot_->radius_mm > 0 ? dot_->radius_mm : static_cast<float>(shown.dot_radius_mm());
    if (const auto other = dot_near(shown, at, tiny, 2 * bare))
        bare = glm::distance(at, other->points[0]) / 2;
    Edit again = *dot_;
    if (hand == Hand::move) again.points = {way_.back()};
    if (hand == Hand::size) again.radius_mm = resized_mm;
    return text_of({Edit::Kind::bare, {at}, bare}) + (hand == Hand::remove ? "" : text_of(again));
}

void Retoucher::retouch(std::string& edits, const RetouchTool& tool, const PlacedDrawing& shown,
                        const Camera& camera, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool free = !io.WantCaptureMouse && place.holds(io.MousePos);
    if (!tool.on || !shown.is_there()) way_.clear();
    if (!tool.on || !shown.is_there() || (way_.empty() && !free)) return;
    const glm::dvec2 corner = shown.layout.picture.low;
    const double unit = shown.layout.page.mm_per_page_unit;
    const double points_per_mm = camera.pixels_per_unit / place.pixels_per_point.x / unit;
    const float line = ImGui::GetFontSize() / 15;
    const auto on_paper = [&](ImVec2 point) {
        const glm::dvec2 at = corner + in_page_units(place.page_at(point, camera)) * unit;
        return glm::vec2(glm::clamp(at, -kLongestSideMm, kLongestSideMm));
    };
    const auto on_screen = [&](glm::vec2 at) {
        return place.point_of(to_canvas(camera, page_point((glm::dvec2(at) - corner) / unit)));
    };
    const glm::vec2 now = on_paper(io.MousePos);
    if (way_.empty()) {
        const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        const glm::vec2 at = pressed ? on_paper(io.MouseClickedPos[ImGuiMouseButton_Left]) : now;
        dot_ = dot_near(shown, at, 0, std::max(kReach * line / points_per_mm, shown.dot_radius_mm()));
        if (pressed) way_ = {at};
    }
    const bool held = !way_.empty();
    if (held && glm::distance(now, way_.back()) >= kStep * line / points_per_mm) way_.push_back(now);
    const auto usual = static_cast<float>(shown.dot_radius_mm());
    float dot_mm = dot_ && dot_->radius_mm > 0 ? dot_->radius_mm : usual;
    if (held && dot_ && tool.hand == Hand::size) {  // by as much as the pointer has gone away from its middle
        dot_mm += glm::distance(way_.back(), dot_->points[0]) - glm::distance(way_[0], dot_->points[0]);
        dot_mm = std::clamp(dot_mm, kSmallestMm, static_cast<float>(kLargestRadiusMm));
    }

    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    place.clip(list);
    // Dark and light, so that they are seen on any ground.
    constexpr ImU32 kDark = IM_COL32(0, 0, 0, 160), kLight = IM_COL32(255, 255, 255, 230);
    const auto ring = [&](ImVec2 centre, double radius_mm) {
        const float radius = static_cast<float>(radius_mm * points_per_mm) + 2 * line;
        list->AddCircle(centre, radius, kDark, 48, line);
        list->AddCircle(centre, radius + line, kLight, 48, line);
    };
    std::vector<ImVec2> way;
    for (const glm::vec2 at : way_) way.push_back(on_screen(at));
    const auto trace = [&](ImU32 colour, double width) {
        list->AddPolyline(way.data(), static_cast<int>(way.size()), colour, 0, static_cast<float>(width));
    };
    if (tool.hand == Hand::whiten) {
        trace(IM_COL32(255, 255, 255, 170), 2 * tool.brush_mm * points_per_mm);
        ring(io.MousePos, tool.brush_mm);
    } else if (tool.hand == Hand::lasso) {
        if (held) way.push_back(way.front());
        trace(kDark, 3 * line);
        trace(kLight, line);
    } else if (tool.hand == Hand::add) {
        ring(io.MousePos, usual);
    } else if (dot_) {
        ring(on_screen(dot_->points[0]), dot_mm);
        if (held && tool.hand == Hand::move) ring(io.MousePos, dot_mm);
    }
    list->PopClipRect();

    if (!held || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const std::string all = edits + edits_made(tool, shown, dot_mm);
    way_.clear();
    static_cast<void>(parse_edits(all));
    edits = all;
}

}  // namespace dapple
