#include "app/viewer/panels/status_line.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"

namespace dapple {
namespace {

void item(const std::string& text, ThemeColour colour = ThemeColour::quiet) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(colour));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0, ImGui::GetTextLineHeight() * 1.4f);
}

}  // namespace

std::string dots_in_words(const StatusFacts& facts) {
    std::string words = grouped(facts.dots) + (facts.dots == 1 ? " dot" : " dots");
    if (facts.figure8)
        words += fmt::format(
            ", {} of them duplicates ({:.0f} %)", grouped(facts.duplicates),
            facts.dots ? 100.0 * static_cast<double>(facts.duplicates) / static_cast<double>(facts.dots)
                       : 0.0);
    return words;
}

void draw_status_line(glm::vec2 corner, glm::vec2 size, const StatusFacts& facts) {
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    float air = (size.y - ImGui::GetTextLineHeight()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, air});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("##status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    item(dots_in_words(facts), ThemeColour::text);
    item(facts.scale < 1e7 ? fmt::format("scale {:.0f}", facts.scale)
                           : fmt::format("scale {:.3g}", facts.scale));
    if (facts.tone_ms > 0) item(fmt::format("tone {:.1f} ms", facts.tone_ms));
    item(fmt::format("placing {:.1f} ms", facts.place_ms));
    item(fmt::format("drawing {:.1f} ms", facts.draw_ms));
    if (facts.frames_per_second > 0) item(fmt::format("{:.0f} fps", facts.frames_per_second));
    item(facts.zoom < 1000 ? fmt::format("{:.0f} %", facts.zoom * 100)
                           : fmt::format("{:.3g} times", facts.zoom));
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace dapple
