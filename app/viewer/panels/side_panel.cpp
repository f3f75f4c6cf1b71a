#include "app/viewer/panels/side_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/panels/action_buttons.h"
#include "app/viewer/panels/compare_panel.h"
#include "app/viewer/panels/crop_rows.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/mask_panel.h"
#include "app/viewer/panels/method_panel.h"
#include "app/viewer/panels/page_panel.h"
#include "app/viewer/panels/pen_panel.h"
#include "app/viewer/panels/tone_panel.h"
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
                 // Tab walks the rows (row_keys.h): ImGui is not to begin typing in one of them too.
                 kNeverAsksForFocus | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoTitleBar |
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_title(title.name, act);
    // One line, whatever there is to say: nothing moves when a picture arrives.
    ImGui::TextDisabled("%s", title.description.c_str());
    if (ImGui::GetItemRectSize().x > ImGui::GetContentRegionAvail().x) tip(title.description.c_str());
    ImGui::Dummy({0, 0});
    draw_action_buttons(title.undo, title.has_project, act);
}

void end_side_panel() {
    ImGui::End();
    ImGui::PopStyleVar();
}

namespace {

void draw_picture_section(Session& session) {
    DrawingSettings& drawing = session.settings.drawing;
    if (!section("Picture")) {  // what cannot be seen is not to paint or to frame
        session.brush.on = session.cropping = false;
        return;
    }
    const PlacedDrawing& page = session.pane().page();
    const Histogram histogram = page.histogram ? *page.histogram : Histogram{};
    draw_tone_panel(drawing, {.histogram = histogram,
                              .drawn = page.tone,
                              .usual_exposure = session.picture().exposure,
                              .usual = page.usual_tone,
                              .mostly_black = mostly_black(histogram, page.tone)});
    draw_rotate_row(drawing.page.quarter_turns);
    slider_row(
        "Photograph", session.settings.picture_opacity,
        {.min = 0,
         .max = 1,
         .neutral = 0,
         .tip = "How much of the photograph shows through under the dots; holding C shows all of it."});
    draw_crop_rows(drawing.page.crop, page.picture_pixels, session.cropping);
    draw_mask_panel(drawing.mask, session.brush);
}

void draw_settings(Session& session, PaletteRow* palettes) {
    ViewerSettings& settings = session.settings;
    draw_picture_section(session);
    const DrawnInfo drawn = session.drawn(session.pane());
    draw_dots_panel(settings.drawing, drawn, settings.unit);
    draw_page_panel(settings.drawing.page, settings.drawing.sheets, drawn.page, settings.unit);
    draw_pen_panel(settings.drawing, settings.unit, {session.pane().page().pens, &session.shown_pens},
                   {palettes, &session.banner});
}

void draw_method(Session& session, const std::function<void()>& open_tile) {
    draw_method_rows(session.settings, {session.tiles(), open_tile});
    draw_compare_panel(session.settings, {session.tiles()});
}

void draw_export_section(const std::function<void(Action)>& act) {
    if (!section("Export")) return;
    const Shortcut& plot = shortcut_of(Action::film_plot);
    if (wide_button(plot.label, plot.tip)) act(Action::film_plot);
    if (wide_button(
            "Export the drawing...",
            with_keys(
                "Saves it for plotters, laser cutters, printers or screens: SVG, PDF, PNG, G-code and more.",
                Action::save_as)
                .c_str()))
        act(Action::save_as);
}

}  // namespace

void SidePanel::draw_rows(Session& session) {
    draw_settings(session, nullptr);
    section("The method");
    draw_method(session, [] {});
    static_cast<void>(draw_spectrum_panel({}));
    TilePanelState shown;
    draw_tile_panel(session.pane().tile(), shown);
}

OpenSections SidePanel::draw(Session& session, const SpectrumInfo& spectrum,
                             const PresetRow::Preview& preview, const std::function<void(Action)>& act,
                             glm::vec2 corner, glm::vec2 size) {
    begin_side_panel(corner, size,
                     {session.picture().name,
                      session.picture().description,
                      {session.undo_words(), session.redo_words()},
                      true},
                     act);
    ViewerSettings& settings = session.settings;
    presets_.draw(
        {settings.drawing, settings.saving},
        [&](const SavedSettings& preset) { session.take_preset(preset); }, preview, session.banner);
    draw_settings(session, &palettes_);
    draw_export_section(act);
    OpenSections open{.method = section("The method", false)};
    if (open.method) {
        draw_film_buttons(act);
        draw_method(session, [&act] { act(Action::open_tile); });
        open.spectrum = draw_spectrum_panel(spectrum);
        const Pane& pane = session.pane();
        if (tiles_seen_ != pane.tiles()) tile_ = {};
        tiles_seen_ = pane.tiles();
        draw_tile_panel(pane.tile(), tile_);
    }
    end_side_panel();
    return open;
}

}  // namespace dapple
