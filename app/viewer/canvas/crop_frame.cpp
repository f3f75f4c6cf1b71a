#include "app/viewer/canvas/crop_frame.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "app/viewer/model/crop_percent.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

constexpr double kGraspPoints = 9;  // on both sides of an edge, at 96 dpi

double longer_side_of(glm::ivec2 size) {
    return std::max({size.x, size.y, 1});
}

// Between percent of the picture as it was opened and ImGui's points.
struct CropView {
    const Framing& framing;
    glm::dvec2 picture;
    const Camera& camera;
    const CanvasPlace& place;

    glm::dvec2 percent_under(ImVec2 point) const {
        const glm::dvec2 page = in_page_units(place.page_at(point, camera));
        return 100.0 * opened_pixel(framing, page * longer_side_of(framing.size())) / picture;
    }
    glm::vec2 on_screen(glm::dvec2 percent) const {
        const glm::dvec2 framed = framed_pixel(framing, percent / 100.0 * picture);
        const glm::dvec2 page = framed / longer_side_of(framing.size());
        return place.corner + glm::vec2(to_canvas(camera, page_point(page)) / place.pixels_per_point);
    }
};

// Which of a box's sides along an axis a pointer grasps.
int side_grasped(double at, double low, double high, double grasp) {
    const double to_low = std::abs(at - low), to_high = std::abs(at - high);
    if (std::min(to_low, to_high) > grasp) return 0;
    return to_low < to_high ? -1 : 1;
}

}  // namespace

glm::dvec2 framed_pixel(const Framing& framing, glm::dvec2 opened) {
    const glm::dvec2 corner = opened_pixel(framing, {0, 0}), way = opened - corner;
    // Quarter turns and mirrors lead along one axis each.
    return {glm::dot(way, opened_pixel(framing, {1, 0}) - corner),
            glm::dot(way, opened_pixel(framing, {0, 1}) - corner)};
}

bool CropFrame::drag(std::optional<Crop>& crop, double proportion, const Framing& framing, glm::ivec2 picture,
                     const Camera& camera, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool let_go = !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const CropView view{framing, glm::dvec2(picture), camera, place};
    if (!held_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.WantCaptureMouse) {
        const Rectangle<double> box = crop_percent(crop, picture);
        const ImVec2 press = io.MouseClickedPos[ImGuiMouseButton_Left];
        const glm::dvec2 at = view.percent_under(press);
        const double grasp_points = kGraspPoints * ImGui::GetFontSize() / 15;
        const glm::dvec2 grasp =
            glm::abs(view.percent_under({press.x + float(grasp_points), press.y + float(grasp_points)}) - at);
        const bool inside =
            glm::all(glm::greaterThan(at, box.low - grasp)) && glm::all(glm::lessThan(at, box.high + grasp));
        if (inside) {
            held_ = {{side_grasped(at.x, box.low.x, box.high.x, grasp.x),
                      side_grasped(at.y, box.low.y, box.high.y, grasp.y)},
                     box,
                     at};
        }
    }
    if (!held_) return false;
    const glm::dvec2 moved = view.percent_under(io.MousePos) - held_->from;
    Rectangle<double> box = held_->box;
    const bool all = held_->sides == glm::ivec2(0);
    for (int axis = 0; axis < 2; ++axis) {
        double &low = box.low[axis], &high = box.high[axis];
        if (all) {
            const double way = std::clamp(moved[axis], -low, 100 - high);
            low += way;
            high += way;
        } else if (held_->sides[axis] < 0) {
            low = std::clamp(low + moved[axis], 0.0, std::max(high - kLeastCropPercent, 0.0));
        } else if (held_->sides[axis] > 0) {
            high = std::clamp(high + moved[axis], std::min(low + kLeastCropPercent, 100.0), 100.0);
        }
    }
    if (!all) box = in_proportion(box, proportion, held_->sides);
    if (moved != glm::dvec2(0)) crop = crop_of_percent(box);
    if (let_go) held_.reset();
    return !let_go;
}

void CropFrame::draw(const std::optional<Crop>& crop, const Framing& framing, glm::ivec2 picture,
                     const Camera& camera, const CanvasPlace& place) const {
    const CropView view{framing, glm::dvec2(picture), camera, place};
    const Rectangle<double> box = crop_percent(crop, picture);
    const auto on_screen = [&](const Rectangle<double>& percent) {
        const glm::vec2 a = view.on_screen(percent.low), b = view.on_screen(percent.high);
        return Rectangle<float>{glm::round(glm::min(a, b)), glm::round(glm::max(a, b))};
    };
    const auto [low, high] = on_screen(box);
    const auto [all_low, all_high] = on_screen({{0, 0}, {100, 100}});
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    place.clip(list);
    const ImU32 away = IM_COL32(60, 60, 60, 150);
    list->AddRectFilled({all_low.x, all_low.y}, {all_high.x, low.y}, away);
    list->AddRectFilled({all_low.x, high.y}, {all_high.x, all_high.y}, away);
    list->AddRectFilled({all_low.x, low.y}, {low.x, high.y}, away);
    list->AddRectFilled({high.x, low.y}, {all_high.x, high.y}, away);
    const float unit = ImGui::GetFontSize() / 15;
    const ImU32 line = colour_of(ThemeColour::accent);
    for (int third = 1; third < 3; ++third) {
        const glm::vec2 at = low + (high - low) * (static_cast<float>(third) / 3);
        const ImU32 faint = IM_COL32(128, 128, 128, 110);
        list->AddLine({at.x, low.y}, {at.x, high.y}, faint, unit);
        list->AddLine({low.x, at.y}, {high.x, at.y}, faint, unit);
    }
    list->AddRect({low.x, low.y}, {high.x, high.y}, line, 0, 0, 2 * unit);
    const glm::vec2 middle = (low + high) * 0.5f;
    for (const float x : std::array{low.x, middle.x, high.x}) {
        for (const float y : std::array{low.y, middle.y, high.y}) {
            if (x == middle.x && y == middle.y) continue;
            const float half = 4 * unit;
            list->AddRectFilled({x - half, y - half}, {x + half, y + half}, colour_of(ThemeColour::panel));
            list->AddRect({x - half, y - half}, {x + half, y + half}, line, 0, 0, 1.5f * unit);
        }
    }
    list->PopClipRect();
}

}  // namespace dapple
