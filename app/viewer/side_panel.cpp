#include "app/viewer/side_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/panels/action_buttons.h"
#include "app/viewer/panels/compare_panel.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/tone_panel.h"
#include "app/viewer/panels/view_panel.h"
#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"
#include "core/image/ink_use.h"

namespace dapple {

void SidePanel::draw(Session& session, SpectrumView& spectrum, const std::function<void(Action)>& act,
                     glm::vec2 corner, glm::vec2 size) {
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("##panels", nullptr,
                 // Tab hides the panels: it is not to begin typing in one of their rows too.
                 kNeverAsksForFocus | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoTitleBar |
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    push_title_font();
    ImGui::TextUnformatted(session.picture().name.c_str());
    pop_title_font();
    hint(session.picture().description.c_str());
    ImGui::Dummy({0, 0});
    draw_action_buttons(act);

    ViewerSettings& settings = session.settings;
    const Tone& drawn = session.pane().page().tone;
    const Histogram& histogram = session.picture().histogram;
    draw_tone_panel(settings.drawing,
                    {.histogram = histogram, .drawn = drawn, .mostly_black = mostly_black(histogram, drawn)});
    const auto open_tile = [&act] { act(Action::open_tile); };
    draw_dots_panel(settings.drawing, session.drawn(session.pane()), {session.tiles(), open_tile});
    draw_view_panel(settings);
    draw_compare_panel(settings, {session.tiles()});
    spectrum.draw();
    const Pane& pane = session.pane();
    if (tiles_seen_ != pane.tiles()) tile_ = {};
    tiles_seen_ = pane.tiles();
    draw_tile_panel(pane.tile(), tile_);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace dapple
