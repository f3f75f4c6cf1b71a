#include "app/viewer/panels/window_panels.h"

#include <algorithm>
#include <limits>

#include <imgui.h>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

constexpr float kStays = 6, kFades = 0.7f;  // seconds
constexpr float kRoomBesideButton = 200;    // at 96 dpi: with less for the message the button is below it

bool stays(const Banner& banner) {
    return banner.kind == BannerKind::error || !(banner.offer.empty() || banner.offer == kShowInFolder);
}

// Counts from the first frame that shows it: the one before may lie long back.
void grow_old(Banner& banner) {
    if (stays(banner)) return;
    banner.shown_for = banner.shown_for < 0 ? 0 : banner.shown_for + ImGui::GetIO().DeltaTime;
    if (banner.shown_for > kStays + kFades) banner = {};
}

}  // namespace

double seconds_until_change(const Banner& banner) {
    if (banner.message.empty() || stays(banner)) return std::numeric_limits<double>::infinity();
    return std::max(0.0f, kStays - std::max(banner.shown_for, 0.0f));
}

bool draw_banner(Banner& banner, glm::vec2 corner, glm::vec2 size) {
    grow_old(banner);
    if (banner.message.empty()) return false;
    const std::string message = printable(banner.message);
    float unit = ImGui::GetTextLineHeight() / 15;
    float cross = ImGui::GetFrameHeight();
    ImVec2 padding{16 * unit, 10 * unit};
    const float room = std::min(size.x - 40 * unit, 620 * unit) - 2 * padding.x - cross - 8 * unit;
    const float button = banner.offer.empty() ? 0 : ImGui::CalcTextSize(banner.offer.c_str()).x + 24 * unit;
    const float beside = button > 0 ? button + 12 * unit : 0;
    const bool below = beside > 0 && room - beside < kRoomBesideButton * unit;
    const float widest = std::max(100.0f, below ? room : room - beside);
    const std::string lines = in_lines(message, widest);
    ImVec2 text = ImGui::CalcTextSize(lines.c_str(), nullptr, false, widest);
    const float inner = below ? std::max(text.x, button) : text.x + beside;
    const float width = inner + 2 * padding.x + cross + 8 * unit;
    const float button_y = below ? padding.y + text.y + 8 * unit : padding.y;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha,
                        std::clamp((kStays + kFades - banner.shown_for) / kFades, 0.0f, 1.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, unit);
    ThemeColour colour = banner.kind == BannerKind::error ? ThemeColour::warning : ThemeColour::accent;
    ImGui::PushStyleColor(ImGuiCol_Border, colour_of(colour));
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(colour));
    begin_bare("##banner", {corner.x + (size.x - width) / 2, corner.y + 16 * unit},
               {width, std::max(padding.y + text.y, button_y + cross) + padding.y});
    ImGui::SetCursorPosY(padding.y + std::max(0.0f, (cross - ImGui::GetTextLineHeight()) / 2));
    ImGui::PushTextWrapPos(padding.x + widest + unit);
    ImGui::TextUnformatted(lines.c_str());
    note_place(message.c_str());
    ImGui::PopTextWrapPos();
    bool taken = false;
    if (button > 0) {
        ImGui::SetCursorPos({below ? padding.x : padding.x + text.x + 12 * unit, button_y});
        taken = ImGui::Button(banner.offer.c_str(), {button, cross});
        note_place(banner.offer.c_str());
    }
    ImGui::SetCursorPos({width - padding.x - cross + 4 * unit, padding.y});
    if (ImGui::Button("x", {cross, cross})) banner.message.clear();
    note_place("Close message");
    if (ImGui::IsWindowHovered() && banner.shown_for > 0) banner.shown_for = 0;
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(3);
    return taken;
}

}  // namespace dapple
