#include "app/viewer/panels/side_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/panels/action_buttons.h"
#include "app/viewer/panels/compare_panel.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/method_panel.h"
#include "app/viewer/panels/page_panel.h"
#include "app/viewer/panels/tone_panel.h"
#include "app/viewer/panels/view_panel.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/image/ink_use.h"

namespace dapple {

void begin_side_panel(glm::vec2 corner, glm::vec2 size, const SidePanelTitle& title,
                      const std::function<void(Action)>& act) {
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("##panels", nullptr,
                 // Tab hides the panels: it is not to begin typing in one of their rows too.
                 kNeverAsksForFocus | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoTitleBar |
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    push_title_font();
    ImGui::TextUnformatted(title.name.c_str());
    pop_title_font();
    if (!title.description.empty()) hint(title.description.c_str());
    ImGui::Dummy({0, 0});
    draw_action_buttons(title.undo, title.has_project, act);
}

void end_side_panel() {
    ImGui::End();
    ImGui::PopStyleVar();
}

bool SidePanel::draw(Session& session, const SpectrumInfo& spectrum, const std::function<void(Action)>& act,
                     glm::vec2 corner, glm::vec2 size) {
    begin_side_panel(corner, size,
                     {session.picture().name,
                      session.picture().description,
                      {session.undo_words(), session.redo_words()},
                      true},
                     act);
    ViewerSettings& settings = session.settings;
    const PlacedDrawing& page = session.pane().page();
    const Histogram histogram = page.histogram ? *page.histogram : Histogram{};
    draw_tone_panel(settings.drawing, {.histogram = histogram,
                                       .drawn = page.tone,
                                       .usual_exposure = session.picture().exposure,
                                       .mostly_black = mostly_black(histogram, page.tone)});
    const auto open_tile = [&act] { act(Action::open_tile); };
    draw_dots_panel(settings.drawing, session.drawn(session.pane()));
    draw_page_panel(settings.drawing.page, session.drawn(session.pane()).page);
    draw_pen_panel(settings.drawing);
    draw_view_panel(settings);
    bool spectrum_open = false;
    if (section("The method", false)) {
        draw_method_rows(settings, {session.tiles(), open_tile});
        draw_compare_panel(settings, {session.tiles()});
        spectrum_open = draw_spectrum_panel(spectrum);
        const Pane& pane = session.pane();
        if (tiles_seen_ != pane.tiles()) tile_ = {};
        tiles_seen_ = pane.tiles();
        draw_tile_panel(pane.tile(), tile_);
    }
    end_side_panel();
    return spectrum_open;
}

}  // namespace dapple
