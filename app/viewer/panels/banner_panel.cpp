#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>

#include <imgui.h>
#include <algorithm>
#include <limits>
#include <optional>

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

namespace {

// `note`: what its button is called.
bool draw_work_banner(const std::string& words, std::optional<double> share, const char* note,
                      glm::vec2 corner, glm::vec2 size) {
    const float unit = ImGui::GetTextLineHeight() / 15;
    const float width = std::max(180 * unit, std::min(size.x - 40 * unit, 420 * unit));
    const ImVec2 padding{16 * unit, 12 * unit};
    const float bar = 5 * unit;
    const float height = ImGui::GetFrameHeight() + (share ? 8 * unit + bar : 0) + 2 * padding.y;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, unit);
    begin_bare("##saving", {corner.x + (size.x - width) / 2, corner.y + size.y - height - 16 * unit},
               {width, height});
    const float button = ImGui::CalcTextSize("Cancel").x + 24 * unit;
    const ImVec2 text = ImGui::GetCursorScreenPos();
    const float inner = width - 2 * padding.x;
    ImGui::PushClipRect(text, {text.x + inner - button - 8 * unit, text.y + height}, true);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopClipRect();
    ImGui::SameLine();
    ImGui::SetCursorPosX(padding.x + inner - button);
    const bool cancelled = ImGui::Button("Cancel", {button, 0});
    note_place(note);
    if (share) {
        const ImVec2 low{text.x, text.y + ImGui::GetFrameHeight() + 8 * unit};
        const float done = inner * static_cast<float>(std::clamp(*share, 0.0, 1.0));
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->AddRectFilled(low, {low.x + inner, low.y + bar}, colour_of(ThemeColour::track), bar / 2);
        if (done >= bar)
            list->AddRectFilled(low, {low.x + done, low.y + bar}, colour_of(ThemeColour::accent), bar / 2);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    return cancelled;
}

}  // namespace

bool draw_saving_banner(const std::string& file_name, double share, glm::vec2 corner, glm::vec2 size) {
    return draw_work_banner(fmt::format("Saving {}: {:.0f} %", printable(file_name), share * 100), share,
                            "Cancel saving", corner, size);
}

bool draw_opening_banner(const std::string& name, glm::vec2 corner, glm::vec2 size) {
    return draw_work_banner("Reading " + name, {}, "Cancel opening", corner, size);
}

bool draw_sampling_banner(double share, glm::vec2 corner, glm::vec2 size) {
    return draw_work_banner(fmt::format("Taking samples: {:.0f} %", share * 100), share, "Cancel sampling",
                            corner, size);
}

}  // namespace dapple
