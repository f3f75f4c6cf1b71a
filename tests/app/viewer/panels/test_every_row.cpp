// What holds for every row of every panel.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/model/history.h"
#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/row.h"
#include "core/tile/tile.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

const std::array<std::string, 2> kTiles{"paper16", "wild64"};
/// What a click folds.
const std::set<std::string> kFolds{"Crop",
                                   "Mask",
                                   "Retouch",
                                   "Drawing",
                                   "Tone",
                                   "Page",
                                   "Ink and paper",
                                   "More tone settings",
                                   "More page settings",
                                   "More pen settings",
                                   "Figures",
                                   "View",
                                   "Samples",
                                   "Compare",
                                   "The tile"};

/// All that the panels edit.
struct Everything {
    ViewerSettings all = {};
    LightsSettings lights = {};
    MaskBrush brush = {};
    RetouchTool retouch = {};
    CropTool cropping = {};
    bool dialog = true;
    DialogChoice whose_dialog = DialogChoice::own;
    Appearance appearance = {};
    std::size_t points_shown = SIZE_MAX;
    ShownPens shown_pens = {};
    Palette drawn_pens = palette_of({.set = PenSet::cmyk});
    PresetRow presets{{}};
    PaletteRow palettes{{}};
    Banner banner = {};
};

/// In which what is not there at first can be used.
Everything with_all_in_use() {
    Everything one;
    ViewerSettings& all = one.all;
    all.density.source = DensitySource::grey;
    all.comparison.on = all.loupe.on = true;
    all.drawing.mark = {DotShape::path, "M0,0 L1,1"};
    all.drawing.dot_size.sizing = DotSizing::fixed;
    all.drawing.page.paper = Paper::custom;
    all.drawing.page.height_mm = 150;
    all.drawing.page.margins = Margins{1, 2, 3, 4};
    all.drawing.sheets.columns = 2;
    one.retouch.hand = Hand::whiten;
    all.drawing.pens = {.set = PenSet::own, .own = palette_of({.set = PenSet::cmyk, .width_mm = 0.3})};
    all.saving.gcode_template.text = "move G1 X{x} Y{y}\ndot G4 P{dwell}\n";
    return one;
}
Everything with_other_choices() {
    Everything one;
    one.all.drawing.dot_size.sizing = DotSizing::by_tone;
    one.all.drawing.style = DrawingStyle::line;
    one.all.drawing.pens.set = PenSet::automatic;
    return one;
}

struct PanelToTest {
    std::string name;
    std::function<void()> draw;
};

std::vector<PanelToTest> all_panels(Everything& one) {
    ViewerSettings& all = one.all;
    DrawingSettings& drawing = all.drawing;
    const auto nothing = [](Action) {};
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    const TileView view = view_of("paper16", tile, PlacerKind::exact);
    std::vector<PanelToTest> panels{
        {"title",
         [&one, nothing] {
             draw_title("a picture", {"dots", "dots"}, nothing);
             draw_action_buttons(true, nothing);
             one.presets.draw(
                 {one.all.drawing, one.all.saving}, [](const SavedSettings&) {},
                 [](const DrawingSettings&) { return EntryPicture{}; }, one.banner);
         }},
        {"tone", [&] { draw_tone_panel(drawing, {.photograph = &all.picture_opacity}); }},
        {"crop",
         [&] {
             draw_crop_rows(drawing.page, one.cropping, {400, 300}, {1, 1});
         }},
        {"mask", [&] { draw_mask_panel(drawing, one.brush); }},
        {"retouch", [&] { draw_retouch_panel(drawing, one.retouch); }},
        {"dots", [&] { draw_dots_panel(drawing, {.dots = 12'345, .scale = 777, .dot_radius_mm = 0.25}); }},
        {"page",
         [&] {
             draw_page_panel(drawing.page, drawing.sheets, {.page = {200, 150, 200}}, all.unit);
         }},
        {"pens",
         [&] {
             draw_pen_panel(drawing, LengthUnit::mm, {one.drawn_pens, {}, &one.shown_pens},
                            {&one.palettes, &one.banner});
         }},
        {"method",
         [&, nothing, view] {
             constexpr Action kFilms[] = {Action::film_growth, Action::film_levels, Action::film_zoom};
             draw_film_buttons(kFilms, nothing);
             draw_method_rows(all, {kTiles});
             draw_compare_panel(all, {kTiles});
             draw_tile_panel(view, one.points_shown);
         }},
        {"lights", [&] { draw_lights_panel(one.lights, LightsInfo{}, {kTiles}); }},
        {"light export", [&] { draw_light_export_panel(one.lights, LightFile::json); }},
        {"preferences", [&] {
             one.dialog = true;
             draw_preferences_panel(one.dialog, one.appearance, one.whose_dialog, &one.all.unit);
         }}};
    for (const DrawingFormatName& format : kDrawingFormats)
        panels.push_back({std::string("export of ") + format.shown, [&all, format] {
                              draw_export_panel(all, format.format,
                                                {.dots = 400, .bytes = 1e4, .trouble = {}});
                          }});
    return panels;
}

void make_high(HeadlessUi& ui, float width = 400) {
    ImGui::GetIO().DisplaySize = {width, 4000};
    for (int i = 0; i < 3; ++i) ui.frame();
    for (const char* folded : {"More tone settings", "More page settings", "More pen settings"})
        if (ui.has(folded)) ui.click(folded);
}

/// Those of rows' controls, and of each side by side.
std::vector<std::string> controls_in(const HeadlessUi& ui) {
    std::vector<std::string> labels;
    for (const auto& [label, place] : ui.places()) {
        const bool part = label.ends_with(" name") || label.ends_with(" value");
        if (!part && !kFolds.contains(label)) labels.push_back(label);
    }
    return labels;
}

/// The rows that edit settings.
void draw_changing(Everything& one) {
    ViewerSettings& all = one.all;
    DrawingSettings& drawing = all.drawing;
    draw_tone_panel(drawing, {});
    draw_dots_panel(drawing, {.dots = 12'345, .scale = 777, .dot_radius_mm = 0.25});
    draw_page_panel(drawing.page, drawing.sheets, {.page = {200, 150, 200}}, all.unit);
    draw_pen_panel(drawing, LengthUnit::mm, {one.drawn_pens});
    draw_method_rows(all, {kTiles});
    draw_compare_panel(all, {kTiles});
    for (const DrawingFormatName& format : kDrawingFormats)
        draw_export_panel(all, format.format, {.dots = 400, .bytes = 1e4, .trouble = {}});
}

bool popup_is_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

std::vector<Everything> states() {
    return {Everything{}, with_all_in_use(), with_other_choices()};
}

}  // namespace

TEST_CASE("a row that is used keeps its place, whatever it changes") {
    for (Everything& one : states()) {
        for (const PanelToTest& panel : all_panels(one)) {
            CAPTURE(panel.name);
            HeadlessUi ui(panel.draw);
            make_high(ui);
            const bool dialog = popup_is_open();
            for (const std::string& label : controls_in(ui)) {
                CAPTURE(label);
                if (!ui.has(label) || label.starts_with("Remove")) continue;  // a pen's rows go with it
                const WidgetPlace place = ui.place(label);
                ui.click(label);
                if (!dialog && popup_is_open()) {
                    ui.key(Key::down);
                    ui.key(Key::enter);
                    ui.key(Key::escape);
                }
                ui.frame();
                // Under another name, perhaps: "Dots in black" for "Dots".
                CHECK(
                    std::ranges::any_of(ui.places(), [&](const auto& each) { return each.second == place; }));
                if (ui.has(label)) CHECK(ui.place(label) == place);
            }
        }
    }
}

TEST_CASE("every row and every button has a tip for a mouse that rests on it") {
    for (Everything& one : states()) {
        for (const PanelToTest& panel : all_panels(one)) {
            CAPTURE(panel.name);
            HeadlessUi ui(panel.draw);
            make_high(ui);
            std::vector<WidgetPlace> seen;
            for (int i = 0; i < 200; ++i) {
                ui.key(Key::tab);
                if (!ui.has(kRowWithKeys)) break;  // nothing can be used
                const WidgetPlace ring = ui.place(kRowWithKeys);
                if (std::ranges::find(seen, ring) != seen.end()) break;
                seen.push_back(ring);
                const glm::vec2 in_it{ring.min.x + 12, (ring.min.y + ring.max.y) / 2};
                const bool fold = std::ranges::any_of(kFolds, [&](const std::string& name) {
                    return ui.has(name) && std::abs(ui.at(name, 0.5f).y - in_it.y) < 3;
                });
                std::string row;
                for (const auto& [label, place] : ui.places())
                    if (label != kRowWithKeys && place.min.y < in_it.y && place.max.y > in_it.y)
                        row += label + "; ";
                if (fold || row.empty()) continue;  // a title, of whose name there is a row as well
                CAPTURE(row);
                ui.move_to(in_it);
                ui.frame(1);
                ui.frame();
                CHECK(ui.has("Tip"));
            }
        }
    }
}

TEST_CASE("in the usual column every label is there to its last letter") {
    for (Everything& one : states()) {
        for (const PanelToTest& panel : all_panels(one)) {
            CAPTURE(panel.name);
            HeadlessUi ui(panel.draw);
            make_high(ui, 340);
            for (const auto& [name, place] : ui.places()) {
                const std::string& label = name;  // clang captures no structured binding
                if (!label.ends_with(" name")) continue;
                CAPTURE(label);
                const std::string shown = label.substr(0, label.size() - 5);
                CHECK(place.max.x - place.min.x >= ImGui::CalcTextSize(shown.c_str()).x);
            }
        }
    }
}

TEST_CASE("in the narrowest column no label, value or control lies on another, or beyond its edge") {
    constexpr float kNarrow = 216;  // of a window 360 wide
    for (Everything& one : states()) {
        one.all.drawing.placing.count = 2'000'000'000;
        for (const PanelToTest& panel : all_panels(one)) {
            if (panel.name == "preferences") continue;  // as wide as it asks for
            CAPTURE(panel.name);
            HeadlessUi ui(panel.draw);
            make_high(ui, kNarrow);
            const WidgetPlaces& places = ui.places();
            for (auto a = places.begin(); a != places.end(); ++a) {
                CAPTURE(a->first);
                CHECK(a->second.min.x >= 0);
                CHECK(a->second.max.x <= kNarrow);
                for (auto b = std::next(a); b != places.end(); ++b) {
                    if (a->first == "Histogram" || b->first == "Histogram") continue;  // handles lie on it
                    CAPTURE(b->first);
                    const glm::vec2 low = glm::max(a->second.min, b->second.min),
                                    high = glm::min(a->second.max, b->second.max);
                    CHECK_FALSE((low.x < high.x - 0.5f && low.y < high.y - 0.5f));
                }
            }
        }
    }
}

TEST_CASE("undo names a change by the row that made it") {
    // One choice for several rows, and rows whose choice is kept in another's.
    const std::map<std::string, std::string> others{{"Dot count", "Dots"},
                                                    {"Inks", "Pens"},
                                                    {"G-code for", "Template"},
                                                    {"Right tile", "Split view"},
                                                    {"Right placer", "Split view"},
                                                    {"Right ranking", "Split view"},
                                                    {"Right side has", "Split view"},
                                                    {"Paper in SVG", "Paper in files"},
                                                    {"Paper in PDF", "Paper in files"}};
    const auto listed = [](Everything& one, const ListedRow* taken, int value) {
        HeadlessUi ui([] {});
        std::vector<ListedRow> rows;
        ImGui::NewFrame();
        {
            const RowListing listing(rows, taken, value);
            draw_changing(one);
        }
        ImGui::EndFrame();
        return rows;
    };
    int changes = 0;
    for (const Everything& state : states()) {
        Everything plain = state;
        for (const ListedRow& row : listed(plain, nullptr, -1)) {
            if (!row.why_not.empty() || row.values.empty()) continue;
            Everything one = state;
            listed(one, &row, row.chosen == 0 ? 1 : 0);
            const std::string words = change_in_words(state.all, one.all);
            if (words.empty()) continue;  // of how the window looks
            ++changes;
            CAPTURE(row.label);
            CAPTURE(words);
            const auto other = others.find(row.label);
            const bool named = words.find(row.label) != std::string::npos;
            CHECK((named || (other != others.end() && words.find(other->second) != std::string::npos)));
        }
    }
    CHECK(changes > 60);
}

}  // namespace dapple
