#include "app/viewer/canvas/page_frame.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <stdexcept>
#include <string>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

namespace {

constexpr float kGrip = 9;  // half the width that can be grasped, at 96 dpi

void draw_handle(ImVec2 centre, float unit, bool hot) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 half{7 * unit, 20 * unit};
    const ImVec2 low{centre.x - half.x, centre.y - half.y}, high{centre.x + half.x, centre.y + half.y};
    list->AddRectFilled(low, high, colour_of(hot ? ThemeColour::accent : ThemeColour::panel), half.x);
    list->AddRect(low, high, colour_of(hot ? ThemeColour::accent : ThemeColour::quiet), half.x, 0, unit);
    const ImU32 ridges = colour_of(hot ? ThemeColour::panel : ThemeColour::quiet);
    for (const float x : {-2 * unit, 2 * unit})
        list->AddLine({centre.x + x, centre.y - 7 * unit}, {centre.x + x, centre.y + 7 * unit}, ridges, unit);
}

}  // namespace

bool draw_split_divider(float& share, const CanvasPlace& place) {
    const float unit = ImGui::GetFontSize() / 15, grip = kGrip * unit;
    const float least = std::min(3 * grip / std::max(place.size.x, 1.0f), 0.5f);
    const float x = place.corner.x + place.size.x * std::clamp(share, least, 1 - least);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    begin_bare("##divider", {std::round(x) - grip, place.corner.y}, {2 * grip, place.size.y},
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    press_area("##grip", {2 * grip, place.size.y});
    note_place("Divider");
    const bool held = ImGui::IsItemActive(), hot = held || ImGui::IsItemHovered();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float middle = std::round(x);
    const ImU32 line = colour_of(hot ? ThemeColour::accent : ThemeColour::quiet);
    list->AddRectFilled({middle - unit, place.corner.y}, {middle + unit, place.corner.y + place.size.y},
                        line);
    draw_handle({middle, place.corner.y + place.size.y / 2}, unit, hot);
    ImGui::End();
    ImGui::PopStyleVar(2);

    const float moved = ImGui::GetIO().MouseDelta.x;
    if (!held || moved == 0) return false;
    const float at = (ImGui::GetIO().MousePos.x - place.corner.x) / std::max(place.size.x, 1.0f);
    share = std::clamp(at, least, 1 - least);
    return true;
}

void draw_pen_trail(std::span<const glm::dvec2> places, const Camera& camera, const CanvasPlace& place) {
    if (places.empty()) return;
    const auto at = [&](glm::dvec2 page_units) {
        return place.point_of(to_canvas(camera, page_point(page_units)));
    };
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    place.clip(list);
    const float unit = ImGui::GetFontSize() / 15;
    const ImU32 colour = colour_of(ThemeColour::accent);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto opacity = static_cast<ImU32>(255 * i / places.size());
        list->AddLine(at(places[i - 1]), at(places[i]), with_opacity(colour, opacity), 1.5f * unit);
    }
    list->AddCircle(at(places.back()), 7 * unit, with_opacity(colour, 255), 0, 2 * unit);
    list->PopClipRect();
}

namespace {

/// Millimetres of the page, from its corner, on screen.
class PageOnScreen {
 public:
    PageOnScreen(const PageLayout& layout, const Camera& camera, const CanvasPlace& place)
        : layout_(layout), camera_(camera), place_(place) {}

    ImVec2 at(glm::dvec2 mm) const {
        const glm::dvec2 origin = to_canvas(camera_, PagePoint(0));
        const glm::dvec2 pixel =
            origin + (mm - layout_.picture.low) / layout_.page.mm_per_page_unit * camera_.pixels_per_unit;
        // Far outside, floats and their rounding are of no use.
        const glm::dvec2 point =
            glm::clamp(pixel, glm::dvec2(-1), camera_.canvas + 1.0) / place_.pixels_per_point;
        return {place_.corner.x + std::round(static_cast<float>(point.x)),
                place_.corner.y + std::round(static_cast<float>(point.y))};
    }
    ImDrawList* begin() const {
        ImDrawList* const list = ImGui::GetBackgroundDrawList();
        place_.clip(list);
        return list;
    }

 private:
    const PageLayout& layout_;
    const Camera& camera_;
    const CanvasPlace& place_;
};

}  // namespace

void draw_margin_lines(const PageLayout& layout, const Camera& camera, const CanvasPlace& place) {
    const glm::dvec2 page(layout.page.width_mm, layout.page.height_mm);
    if (!(layout.page.mm_per_page_unit > 0) || layout.within_margins == Rectangle<double>{{0, 0}, page})
        return;
    const PageOnScreen on_screen(layout, camera, place);
    ImDrawList* const list = on_screen.begin();
    list->AddRect(on_screen.at(layout.within_margins.low), on_screen.at(layout.within_margins.high),
                  with_opacity(colour_of(ThemeColour::accent), 0x90));
    list->PopClipRect();
}

void draw_sheet_lines(const PageLayout& layout, const Sheet& sheets, const Camera& camera,
                      const CanvasPlace& place) {
    if (!(layout.page.mm_per_page_unit > 0) || !is_several(sheets)) return;
    glm::dvec2 size;
    try {
        const PageSize sheet = sheet_of(layout.page, sheets).size;
        size = {sheet.width_mm, sheet.height_mm};
    } catch (const std::runtime_error&) {
        return;  // the page's section says why
    }
    const PageOnScreen on_screen(layout, camera, place);
    const glm::dvec2 page(layout.page.width_mm, layout.page.height_mm),
        step = sheet_step(layout.page, sheets);
    const ImU32 accent = colour_of(ThemeColour::accent), edge = with_opacity(accent, 0xc0),
                strip = with_opacity(accent, 0x28);
    ImDrawList* const list = on_screen.begin();
    // What two neighbours share, along the whole page; without an overlap, where one ends and the other
    // begins.
    const auto seam = [&](glm::dvec2 from, glm::dvec2 to) {
        const ImVec2 low = on_screen.at(from), high = on_screen.at(to);
        if (sheets.overlap_mm > 0) list->AddRectFilled(low, high, strip);
        list->AddRect(low, high, edge);
    };
    for (int column = 1; column < sheets.columns; ++column)
        seam({column * step.x, 0}, {(column - 1) * step.x + size.x, page.y});
    for (int row = 1; row < sheets.rows; ++row)
        seam({0, row * step.y}, {page.x, (row - 1) * step.y + size.y});
    const float line = ImGui::GetTextLineHeight(), air = line / 3;
    for (const Sheet& sheet : all_sheets(sheets)) {
        const glm::dvec2 corner = step * glm::dvec2(sheet.column - 1, sheet.row - 1);
        const ImVec2 low = on_screen.at(corner), high = on_screen.at(corner + size);
        const std::string name = name_of(sheet);
        const ImVec2 text = ImGui::CalcTextSize(name.c_str());
        if (high.x - low.x < 3 * text.x || high.y - low.y < 3 * line) continue;
        const ImVec2 middle{std::round((low.x + high.x - text.x) / 2),
                            std::round((low.y + high.y - line) / 2)};
        list->AddRectFilled({middle.x - air, middle.y - air / 2},
                            {middle.x + text.x + air, middle.y + line + air / 2},
                            with_opacity(colour_of(ThemeColour::panel), 0xd0), air);
        list->AddText(middle, colour_of(ThemeColour::text), name.c_str());
    }
    list->PopClipRect();
}

}  // namespace dapple
