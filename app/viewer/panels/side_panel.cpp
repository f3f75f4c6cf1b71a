#include "app/viewer/panels/side_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "app/viewer/widgets/widgets.h"
#include "core/image/auto_tone.h"

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
    draw_title(title.name, title.undo, act);
    // One line, whatever there is to say: nothing moves when a picture arrives.
    ImGui::TextDisabled("%s", title.description.c_str());
    if (ImGui::GetItemRectSize().x > ImGui::GetContentRegionAvail().x) tip(title.description.c_str());
    ImGui::Dummy({0, 0});
    draw_action_buttons(title.has_project, act);
}

void end_side_panel() {
    ImGui::End();
    ImGui::PopStyleVar();
}

namespace {

constexpr char kMethodTitle[] = "The method";

std::vector<std::uint64_t> dots_by_pen(const PlacedDrawing& page) {
    std::vector<std::uint64_t> dots(page.plan.pens.size());
    for (const Dots& piece : page.dots.pieces)
        if (static_cast<std::size_t>(piece.pen) < dots.size())
            dots[static_cast<std::size_t>(piece.pen)] += piece.size();
    return dots;
}

void draw_settings(Session& session, PaletteRow* palettes) {
    ViewerSettings& settings = session.settings;
    DrawingSettings& drawing = settings.drawing;
    const PlacedDrawing& page = session.pane().page();
    const DrawnInfo drawn = session.drawn();
    const Histogram histogram = page.plan.histogram ? *page.plan.histogram : Histogram{};
    draw_dots_panel(drawing, drawn, settings.unit);
    draw_tone_panel(drawing, {.histogram = histogram,
                              .drawn = page.plan.tone,
                              .usual_exposure = session.picture().exposure,
                              .usual = page.plan.usual_tone,
                              .photograph = &settings.picture_opacity});
    draw_pen_panel(drawing, settings.unit, {page.plan.pens, dots_by_pen(page), &session.shown_pens},
                   {palettes, &session.banner}, mostly_black(histogram, page.plan.tone));
    draw_page_panel(drawing.page, drawing.sheets, page.layout, settings.unit);
}

void draw_crop(Session& session) {
    PageSetup& setup = session.settings.drawing.page;
    const PlacedDrawing& page = session.pane().page();
    draw_crop_rows(setup, session.cropping, page.plan.opened, session.room_for_crop());
}

void draw_method(Session& session, const std::function<void(Action)>& act) {
    draw_steps(session.settings);
    hint("While this column is open dots stay where they were placed: nothing relaxes.");
    draw_amount_rows(session.settings.drawing, session.drawn(), session.settings.unit);
    constexpr Action kFilms[] = {Action::film_growth, Action::film_levels, Action::film_zoom};
    draw_film_buttons(kFilms, act);
    draw_method_rows(session.settings, {session.tiles(), [&act] { act(Action::open_tile); }});
    draw_compare_panel(session.settings, {session.tiles()});
}

}  // namespace

void SidePanel::draw_rows(Session& session) {
    draw_settings(session, nullptr);
    draw_crop(session);
    draw_mask_panel(session.settings.drawing, session.brush);
    draw_retouch_panel(session.settings.drawing, session.retouch);
    section(kMethodTitle);
    draw_method_rows(session.settings, {session.tiles()});
    draw_compare_panel(session.settings, {session.tiles()});
    static_cast<void>(draw_spectrum_panel({}));
    std::size_t shown = SIZE_MAX;
    draw_tile_panel(session.pane().tile(), shown);
}

void SidePanel::turn_to(Column column, Session& session) {
    column_ = column == column_ ? Column::drawing : column;
    session.cropping.on = column_ == Column::crop;
    session.brush.on = column_ == Column::mask;
    session.as_placed = column_ == Column::method;
    session.retouch.on = column_ == Column::retouch;
}

// What is asked for by a list of all rows may be in another column.
void SidePanel::turn_to_revealed(Session& session) {
    const ListedRow* const row = row_to_reveal();
    if (!row || row->label == revealed_) {
        if (!row) revealed_.clear();
        return;
    }
    revealed_ = row->label;
    const std::string& section = row->sections.empty() ? row->label : row->sections.front();
    const Column wanted = section == "Crop"         ? Column::crop
                          : section == "Mask"       ? Column::mask
                          : section == "Retouch"    ? Column::retouch
                          : section == kMethodTitle ? Column::method
                                                    : Column::drawing;
    if (wanted != column_) turn_to(wanted, session);
}

OpenSections SidePanel::draw(Session& session, const SpectrumInfo& spectrum,
                             const PresetRow::Preview& preview, const std::function<void(Action)>& act,
                             glm::vec2 corner, glm::vec2 size) {
    turn_to_revealed(session);
    begin_side_panel(corner, size,
                     {session.picture().name,
                      session.picture().description,
                      {session.undo_words(), session.redo_words()},
                      true},
                     act);
    ViewerSettings& settings = session.settings;
    OpenSections open{.method = column_ == Column::method};
    if (column_ != Column::drawing &&
        wide_button("Back to the drawing", "To the settings of the drawing.   Escape"))
        turn_to(Column::drawing, session);
    switch (column_) {
        case Column::drawing: {
            presets_.draw(
                {settings.drawing, settings.saving},
                [&](const SavedSettings& preset) { session.take_preset(preset); }, preview, session.banner);
            draw_settings(session, &palettes_);
            ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y});
            constexpr Action kFilms[] = {Action::film_growth, Action::film_plot};
            draw_film_buttons(kFilms, act);
            for (const Action action : {Action::variations, Action::method}) {
                const Shortcut& button = shortcut_of(action);
                if (wide_button(button.label, with_keys(button.tip, action).c_str())) act(action);
            }
            break;
        }
        case Column::crop:
            draw_crop(session);
            break;
        case Column::mask:
            draw_mask_panel(settings.drawing, session.brush);
            break;
        case Column::retouch:
            session.retouch.on = draw_retouch_panel(settings.drawing, session.retouch);
            break;
        case Column::method:
            draw_method(session, act);
            open.spectrum = draw_spectrum_panel(spectrum);
            const Pane& pane = session.pane();
            if (tiles_seen_ != pane.tiles()) points_shown_ = SIZE_MAX;
            tiles_seen_ = pane.tiles();
            draw_tile_panel(pane.tile(), points_shown_);
            break;
    }
    end_side_panel();
    return open;
}

}  // namespace dapple
