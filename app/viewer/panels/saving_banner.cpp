#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"

namespace dapple {
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
