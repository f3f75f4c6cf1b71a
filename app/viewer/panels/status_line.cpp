#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

float air_between() {
    return ImGui::GetTextLineHeight() * 1.4f;
}

float width_of(const std::vector<StatusItem>& items) {
    float width = -air_between();
    for (const StatusItem& item : items) width += ImGui::CalcTextSize(item.text.c_str()).x + air_between();
    return width;
}

}  // namespace

std::string dots_in_words(const StatusInfo& info) {
    std::string words = grouped(info.dots) + (info.dots == 1 ? " dot" : " dots");
    if (info.as_dense_as > 0) words += ", here as dense as " + in_round_words(info.as_dense_as);
    if (info.figure8)
        words += fmt::format(
            ", {} of them duplicates ({:.0f} %)", grouped(info.duplicates),
            info.dots ? 100.0 * static_cast<double>(info.duplicates) / static_cast<double>(info.dots) : 0.0);
    return words;
}

std::string paper_in_words(const PageSize& page, LengthUnit unit) {
    if (unit == LengthUnit::inch)
        return fmt::format("{:.3g} x {:.3g} in", page.width_mm / kMmPerInch, page.height_mm / kMmPerInch);
    return fmt::format("{:.0f} x {:.0f} mm", page.width_mm, page.height_mm);
}

std::vector<StatusItem> status_items(const StatusInfo& info) {
    std::vector<StatusItem> items{{dots_in_words(info), 6}};
    if (!info.paper.empty()) items.push_back({info.paper, 3});
    if (info.zoom > 0) items.push_back({in_round_words(100 * info.zoom) + " %", 5});
    if (!info.plotting.empty()) items.push_back({info.plotting, 4});
    const bool settles = info.steps < info.all_steps;
    const bool is_long = info.placing_seconds > kLongPlacing;
    if (is_long && !settles)
        items.push_back(
            {info.placed_share
                 ? fmt::format("Placing {:.0f} % (Esc stops)", std::min(100 * *info.placed_share, 99.0))
                 : fmt::format("Placing {:.0f} s (Esc stops)", info.placing_seconds),
             7});
    if (settles)
        items.push_back(
            {fmt::format("Relaxing {} of {}{}", info.steps, info.all_steps, is_long ? " (Esc stops)" : ""),
             7});
    else if (info.preview)
        items.push_back({"Preview", 7});
    if (info.frames_per_second > 0) items.push_back({fmt::format("{:.0f} fps", info.frames_per_second), 1});
    if (!info.method) return items;
    items.push_back({"scale " + in_round_words(info.scale), 4});
    if (info.tone_ms > 0) items.push_back({fmt::format("tone {:.1f} ms", info.tone_ms), 0});
    if (!is_long) items.push_back({fmt::format("placing {:.1f} ms", info.place_ms), 3});
    if (!settles && info.steps > 0)
        items.push_back({fmt::format("{} steps {:.0f} ms", info.steps, info.relax_ms), 3});
    items.push_back({fmt::format("drawing {:.1f} ms", info.draw_ms), 2});
    return items;
}

std::optional<double> progress_of(const StatusInfo& info) {
    if (info.placing_seconds <= kLongPlacing) return std::nullopt;
    if (info.steps < info.all_steps) return static_cast<double>(info.steps) / info.all_steps;
    return info.placed_share;
}

std::vector<StatusItem> fitting(std::vector<StatusItem> items, float width) {
    while (items.size() > 1 && width_of(items) > width)
        items.erase(std::ranges::min_element(items, {}, &StatusItem::importance));
    return items;
}

void draw_status_line(glm::vec2 corner, glm::vec2 size, const StatusInfo& info) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    float air = (size.y - ImGui::GetTextLineHeight()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, air});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    begin_bare("##status", {corner.x, corner.y}, {size.x, size.y},
               ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (const auto share = progress_of(info)) {
        const float bar = 3 * ImGui::GetTextLineHeight() / 15;
        const auto done = static_cast<float>(*share) * size.x;
        ImDrawList* const list = ImGui::GetWindowDrawList();
        const ImVec2 low{corner.x, corner.y};
        list->PushClipRect(low, {low.x + size.x, low.y + bar});
        list->AddRectFilled(low, {low.x + size.x, low.y + bar}, colour_of(ThemeColour::track));
        list->AddRectFilled(low, {low.x + done, low.y + bar}, colour_of(ThemeColour::accent));
        list->PopClipRect();
        note_place("Progress", {{low.x, low.y}, {low.x + done, low.y + bar}});
    }
    bool first = true;
    for (const StatusItem& item : fitting(status_items(info), ImGui::GetContentRegionAvail().x)) {
        if (!std::exchange(first, false)) ImGui::SameLine(0, air_between());
        const bool main = item.importance >= 6;
        ImGui::PushStyleColor(ImGuiCol_Text, colour_of(main ? ThemeColour::text : ThemeColour::quiet));
        ImGui::TextUnformatted(item.text.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace dapple
