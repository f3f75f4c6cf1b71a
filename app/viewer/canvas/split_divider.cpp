#include "app/viewer/canvas/split_divider.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

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
    ImGui::SetNextWindowPos({std::round(x) - grip, place.corner.y});
    ImGui::SetNextWindowSize({2 * grip, std::max(place.size.y, 1.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("##divider", nullptr,
                 kNeverAsksForFocus | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
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

}  // namespace dapple
