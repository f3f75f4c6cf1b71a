// The panels, clicked and dragged without a window.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

#include "app/files/gcode_choice.h"
#include "app/shown_text.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/panels/compare_panel.h"
#include "app/viewer/panels/crop_rows.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/export_panel.h"
#include "app/viewer/panels/method_panel.h"
#include "app/viewer/panels/page_panel.h"
#include "app/viewer/panels/pen_panel.h"
#include "app/viewer/panels/saving_banner.h"
#include "app/viewer/panels/status_line.h"
#include "app/viewer/panels/tile_panel.h"
#include "app/viewer/panels/tone_panel.h"
#include "core/tile/tile.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

const std::array<std::string, 2> kTiles{"paper16", "wild64"};

DrawingSettings in_own_tone(const Tone& tone) {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.tone = tone;
    return settings;
}

struct DotsUi {
    ViewerSettings all = {};
    DrawingSettings& settings = all.drawing;
    DrawnInfo drawn{.dots = 12'345, .scale = 777, .dot_radius_mm = 0.25};
    HeadlessUi ui{[this] {
        draw_dots_panel(settings, drawn);
        draw_method_rows(all, {kTiles});
    }};
};

}  // namespace

TEST_CASE("a panel that nobody touches changes nothing") {
    DrawingSettings settings = in_own_tone({.contrast = 0.3f, .blur = 50});
    const Tone& tone = settings.tone;
    bool changed = false;
    HeadlessUi ui([&] { changed |= draw_tone_panel(settings, {}); });
    ui.move_to({200, 120});
    for (int i = 0; i < 5; ++i) ui.frame();
    CHECK_FALSE(changed);
    CHECK(tone == Tone{.contrast = 0.3f, .blur = 50});
}

TEST_CASE("dragging a tone slider to its ends gives its range") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.drag("Contrast", 0.5f, 1.0f);
    CHECK(tone.contrast == 1);
    ui.drag("Contrast", 1.0f, 0.0f);
    CHECK(tone.contrast == -1);
    ui.drag("Gamma", 0.5f, 1.0f);
    CHECK(tone.gamma == 4);
    ui.drag("Blur", 0.0f, 0.5f);
    CHECK(tone.blur == doctest::Approx(10).epsilon(0.02));
    CHECK(tone.brightness == 0);
}

TEST_CASE("exposure is the picture's own until it is moved, and again once it is put back") {
    DrawingSettings settings;
    ToneInfo facts{.usual_exposure = -3.2f};
    bool changed = false;
    HeadlessUi ui([&] { changed |= draw_tone_panel(settings, facts); });
    CHECK_FALSE(changed);
    const float below = ui.place("Black point").min.y;
    ui.enter("Exposure", "1.5");
    CHECK_FALSE(settings.automatic_exposure);
    CHECK(settings.tone.exposure == 1.5f);
    CHECK(settings.automatic_tone);  // black, white and gamma still follow
    ui.click("true");
    CHECK(settings.tone.exposure == 1.5f);
    ui.enter("Exposure", "-3.2");
    CHECK(settings.automatic_exposure);

    ui.enter("Exposure", "2");
    ui.double_click("Exposure name");
    CHECK(settings.automatic_exposure);
    facts.usual_exposure = 0;
    ui.frame();
    ui.frame();
    CHECK(ui.place("Black point").min.y == below);  // no row moves meanwhile
}

TEST_CASE("a slider goes on following a mouse that leaves its row") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.move_to(ui.at("Brightness", 0.5f));
    ui.press();
    ui.move_to(ui.at("Brightness", 0.9f) + glm::vec2(0, 300));
    CHECK(tone.brightness > 0.7f);
    ui.release();
    ui.move_to(ui.at("Brightness", 0.1f));
    CHECK(tone.brightness > 0.7f);
}

TEST_CASE("black and white point push each other and never meet") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.drag("Black point", 0.0f, 1.0f);
    CHECK(tone.black_point < tone.white_point);
    ui.drag("White point", 1.0f, 0.0f);
    CHECK(tone.black_point < tone.white_point);
    CHECK(tone.black_point >= 0);
    CHECK(tone.white_point < 0.1f);
}

TEST_CASE("a double-click on a slider's name brings the neutral value back") {
    DrawingSettings settings = in_own_tone({.gamma = 3});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.double_click("Gamma name");
    CHECK(tone.gamma == 1);
}

TEST_CASE("Ctrl+click on a slider takes a typed number, beyond the track where that is allowed") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.enter("Blur", "250");
    CHECK(tone.blur == 100);
}

TEST_CASE("the invert switch toggles") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    HeadlessUi ui([&] { draw_tone_panel(settings, {}); });
    ui.click("Invert");
    CHECK(tone.invert);
    ui.click("Invert");
    CHECK_FALSE(tone.invert);
}

TEST_CASE("going from count to scale and back keeps the drawing") {
    DotsUi f;
    REQUIRE(f.settings.placing.count == kDefaultDots);
    f.ui.click("tone");
    CHECK_FALSE(f.settings.placing.count);
    CHECK(f.settings.placing.scale == 777);
    f.ui.click("number");
    CHECK(f.settings.placing.count == 12'345);
}

TEST_CASE("the scale slider is logarithmic") {
    DotsUi f;
    f.ui.click("tone");
    f.ui.drag("Fineness", 0.3f, 0.5f);
    CHECK(f.settings.placing.scale == doctest::Approx(1000).epsilon(0.05));
    f.ui.drag("Fineness", 0.5f, 1.0f);
    CHECK(f.settings.placing.scale == 100'000);
}

TEST_CASE("the count slider gives whole numbers") {
    DotsUi f;
    f.ui.drag("Dots", 0.2f, 1.0f);
    CHECK(f.settings.placing.count == 2'000'000);
    f.ui.drag("Dots", 0.9f, 0.0f);
    CHECK(f.settings.placing.count == 100);
}

TEST_CASE("a typed count is at most what fits into memory, and the panel says why") {
    DotsUi f;
    f.drawn.most_dots = 7'654'321;
    f.ui.frame();
    f.ui.enter("Dots", "99999999999");
    CHECK(f.settings.placing.count == 7'654'321);
    CHECK(f.ui.has("Refusal"));
    f.ui.move_to({1, 899});
    f.ui.frame(5);
    CHECK_FALSE(f.ui.has("Tip"));
    f.ui.move_to(f.ui.at("Dots", 0.3f));
    f.ui.frame(1);
    CHECK(f.ui.has("Tip"));
    // Nothing moves beneath the pointer when there are that many.
    const WidgetPlace below = f.ui.place("Radius, mm");
    f.drawn.dots = 7'654'321;
    f.ui.frame();
    CHECK(f.ui.place("Radius, mm") == below);
}

TEST_CASE("a typed scale is at most the one whose dots fit into memory") {
    DotsUi f;
    f.drawn.most_dots = 1'234'500;  // a hundred times as many as are drawn
    f.ui.click("tone");
    f.ui.enter("Fineness", "99999999999");
    CHECK(f.settings.placing.scale == doctest::Approx(77'700).epsilon(1e-9));
    f.ui.drag("Fineness", 0.5f, 1.0f);
    CHECK(f.settings.placing.scale == doctest::Approx(77'700).epsilon(1e-9));
}

TEST_CASE("no value is so long that it reaches over its slider's track") {
    DotsUi f;
    for (const std::uint64_t count : {2'000'000ull, 1'000'000'000ull}) {
        f.settings.placing.count = count;
        f.ui.frame();
        const WidgetPlace value = f.ui.place("Dots value"), track = f.ui.place("Dots");
        CHECK(value.min.x >= track.max.x);
        CHECK(value.max.x - value.min.x > ImGui::CalcTextSize(grouped(count).c_str()).x);
        CHECK(track.max.x - track.min.x > 60);
    }
}

TEST_CASE("a look at Figure 8 and back leaves everything as it was, and no row moves meanwhile") {
    DotsUi f;
    const DrawingSettings before = f.settings;
    const auto rows = [&] {
        std::vector<WidgetPlace> places;
        for (const char* row : {"Dots", "Even out", "exact", "Tile", "Ranking"})
            places.push_back(f.ui.place(row));
        return places;
    };
    const std::vector<WidgetPlace> places = rows();
    f.ui.click("Figure 8");
    CHECK(f.settings.placer == PlacerKind::figure8);
    CHECK(f.settings.placing.count == before.placing.count);
    CHECK(tile_in_use(f.settings) == "paper16");
    CHECK(rows() == places);
    f.ui.click("exact");
    CHECK(f.settings == before);
}

TEST_CASE("what Figure 8 does not know is greyed, says why and cannot be used") {
    DotsUi f;
    f.ui.click("Figure 8");
    const DrawingSettings before = f.settings;
    f.ui.drag("Even out", 0.1f, 0.9f);
    f.ui.click("Ranking");
    CHECK_FALSE(f.ui.has("farthest point"));
    CHECK(f.settings == before);
    f.ui.move_to(f.ui.at("Even out", 0.5f));
    f.ui.frame(1);
    CHECK(f.ui.has("Tip"));
}

TEST_CASE("what is typed may be 40k or 8in, and what cannot be is said") {
    DotsUi f;
    f.ui.enter("Dots", "40k");
    CHECK(f.settings.placing.count == 40'000);
    CHECK_FALSE(f.ui.has("Refusal"));
    f.ui.enter("Dots", "0");
    CHECK(f.settings.placing.count == 1);
    CHECK(f.ui.has("Refusal"));
    f.ui.frame(5);
    f.ui.frame();
    CHECK_FALSE(f.ui.has("Refusal"));
    f.ui.enter("Dots", "many");
    CHECK(f.settings.placing.count == 1);
    CHECK(f.ui.has("Refusal"));
}

TEST_CASE("the page is a paper, or as large as is typed, with margins alike or each its own") {
    PageSetup setup;
    Sheet sheets;
    LengthUnit unit = LengthUnit::mm;
    const PageSize drawn{200, 150, 200};
    HeadlessUi ui([&] {
        draw_rotate_row(setup.quarter_turns);
        draw_page_panel(setup, sheets, drawn, unit);
    });
    // A page of the picture's shape has no orientation, and one side rules.
    ui.click("Orientation");
    CHECK_FALSE(ui.has("landscape"));
    ui.enter("Height, mm", "8in");
    CHECK(*setup.height_mm == doctest::Approx(203.2));
    ui.enter("Width, mm", "180");
    CHECK(setup == PageSetup{.width_mm = 180});

    ui.click("Paper size");
    ui.click("A4");
    ui.click("Orientation");
    ui.click("landscape");
    ui.click("fill");
    ui.click("90");
    ui.enter("Margin, mm", "15");
    CHECK(setup == PageSetup{.paper = Paper::a4,
                             .orientation = PageOrientation::landscape,
                             .width_mm = 180,
                             .margins = {15, 15, 15, 15},
                             .fit = PageFit::fill,
                             .quarter_turns = 1});
    ui.click("each side");
    ui.enter("Left, mm", "1in");
    CHECK(setup.margins == Margins{15, 15, 15, 25.4});
    ui.click("equal");
    CHECK(setup.margins == Margins{15, 15, 15, 15});
    ui.click("Paper size");
    ui.click("custom");
    CHECK(setup.width_mm == 200);
    CHECK(*setup.height_mm == 150);
    CHECK(setup.orientation == PageOrientation::automatic);
}

TEST_CASE("a mural's sheets share strips, and say how large they are or why they cannot be") {
    PageSetup setup;
    Sheet sheets;
    LengthUnit unit = LengthUnit::mm;
    HeadlessUi ui([&] {
        draw_page_panel(setup, sheets, {200, 150, 200}, unit);
        wide_button("Below", "");
    });
    CHECK(sheets == Sheet{});
    const WidgetPlace below = ui.place("Below");
    ui.enter("Sheets across", "2");
    ui.enter("Sheets down", "3");
    ui.enter("Overlap, mm", "1.5cm");
    CHECK(sheets == Sheet{.columns = 2, .rows = 3, .overlap_mm = 15});
    CHECK(ui.has("Sheets"));
    CHECK(ui.place("Below") == below);
    ui.enter("Overlap, mm", "120");
    CHECK(ui.has("No sheets"));
    CHECK(ui.place("Below") == below);
    ui.enter("Sheets across", "1000");
    CHECK(sheets.columns == kMostSheetsAtOnce);
}

TEST_CASE("a fixed dot size begins at the one on screen") {
    DotsUi f;
    const WidgetPlace place = f.ui.place("Radius, mm");
    f.ui.drag("Radius, mm", 0.5f, 1.0f);
    CHECK(f.settings.dot_size == DotSize{});  // greyed
    f.ui.click("fixed");
    CHECK(f.ui.place("Radius, mm") == place);
    CHECK(f.settings.dot_size.sizing == DotSizing::fixed);
    CHECK(f.settings.dot_size.radius_mm == 0.25);
    f.ui.drag("Radius, mm", 0.5f, 1.0f);
    CHECK(f.settings.dot_size.radius_mm == 5);
    f.ui.click("auto");
    CHECK(f.settings.dot_size.sizing == DotSizing::automatic);
}

TEST_CASE("dots sized by tone have two radii that never cross, and no count of their own") {
    DotsUi f;
    f.ui.click("by tone");
    CHECK(f.settings.dot_size.sizing == DotSizing::by_tone);
    const std::optional<std::uint64_t> count = f.settings.placing.count;
    f.ui.drag("Dots", 0.5f, 1.0f);
    CHECK(f.settings.placing.count == count);  // greyed, and says why
    f.ui.frame(1);
    CHECK(f.ui.has("Tip"));
    f.ui.drag("Smallest, mm", 0.5f, 1.0f);
    CHECK(f.settings.dot_size.largest_mm >= f.settings.dot_size.smallest_mm);
    f.ui.drag("Largest, mm", 1.0f, 0.0f);
    CHECK(f.settings.dot_size.smallest_mm <= f.settings.dot_size.largest_mm);
    CHECK(f.settings.dot_size.largest_mm < 0.03);
}

TEST_CASE("the relax row shows the usual steps until it is moved") {
    DotsUi f;
    f.drawn.steps = 4;
    f.ui.frame();
    CHECK_FALSE(f.settings.relax);
    f.ui.drag("Even out", 0.2f, 1.0f);
    CHECK(f.settings.relax == 20);
    f.ui.drag("Even out", 1.0f, 0.0f);
    CHECK(f.settings.relax == 0);
}

TEST_CASE("a slider moved under the automatic tone goes on from what is drawn") {
    DrawingSettings settings;
    const Tone drawn{.black_point = 0.1f, .white_point = 0.8f, .gamma = 2, .detail = 0.5f};
    HeadlessUi ui([&] { draw_tone_panel(settings, {.drawn = drawn}); });
    ui.frame();
    CHECK(settings.automatic_tone);
    ui.drag("Brightness", 0.5f, 1.0f);
    CHECK_FALSE(settings.automatic_tone);
    CHECK(settings.tone.brightness == 1);
    CHECK(settings.tone.gamma == 2);
    CHECK(settings.tone.white_point == 0.8f);
    ui.click("true");
    CHECK(settings.tone == Tone{});
    CHECK_FALSE(settings.automatic_tone);
    ui.click("auto");
    CHECK(settings.automatic_tone);
}

TEST_CASE("a double-click under a tone of one's own brings what automatic tone chose, and all of it makes it auto") {
    DrawingSettings settings;
    const Tone chosen{.black_point = 0.1f, .white_point = 0.8f, .gamma = 2, .detail = 0.5f, .black = 0.95};
    HeadlessUi ui([&] { draw_tone_panel(settings, {.drawn = chosen, .usual = chosen}); });
    ui.double_click("Gamma name");  // which has moved nothing
    CHECK(settings.automatic_tone);
    ui.drag("Gamma", 0.5f, 0.0f);
    ui.enter("Black point", "0.3");
    ui.enter("Black", "0.6");
    CHECK_FALSE(settings.automatic_tone);
    ui.double_click("Gamma name");
    CHECK(settings.tone.gamma == 2);
    ui.double_click("Black name");
    CHECK(settings.tone.black == 0.95);
    CHECK_FALSE(settings.automatic_tone);
    ui.double_click("Black point name");
    const DrawingSettings fresh;
    CHECK(settings.automatic_tone);
    CHECK(settings.tone == fresh.tone);
}

TEST_CASE("black is as solid as the dots allow until its row is moved, and again once that is put back") {
    DrawingSettings settings;
    ToneInfo facts{.usual = {.black = 0.95}};
    HeadlessUi ui([&] { draw_tone_panel(settings, facts); });
    ui.enter("Black", "0.7");
    CHECK(settings.tone.black == 0.7);
    CHECK(settings.automatic_tone);  // the other tones still follow
    ui.enter("Black", "0.95");
    CHECK_FALSE(settings.tone.black);
    ui.enter("Black", "1");
    CHECK(settings.tone.black == 1);
    settings.style = DrawingStyle::line;
    ui.frame();
    ui.drag("Black", 1.0f, 0.0f);
    CHECK(settings.tone.black == 1);
}

TEST_CASE("where nearly all dots would go into black, one click brings white ink on black") {
    DrawingSettings settings;
    HeadlessUi ui([&] { draw_tone_panel(settings, {.mostly_black = !settings.tone.invert}); });
    ui.click("White ink on black paper");
    CHECK(settings.tone.invert);
    CHECK(settings.ink == kWhite);
    CHECK(settings.paper == kBlack);
    ui.click("Black ink on white paper");
    CHECK_FALSE(settings.tone.invert);
    CHECK(settings.ink == kBlack);
    CHECK(settings.paper == kWhite);
}

TEST_CASE("a picture's arrival and a tone that is moved leave every row of the picture where it is") {
    DrawingSettings settings;
    ToneInfo info;
    HeadlessUi ui([&] {
        draw_tone_panel(settings, info);
        draw_rotate_row(settings.page.quarter_turns);
    });
    const WidgetPlaces before = ui.places();
    info.histogram.counts[300] = info.histogram.total = 1000;
    info.usual_exposure = 5;
    info.mostly_black = true;
    for (int i = 0; i < 2; ++i) ui.frame();
    for (const char* row : {"Exposure", "Black point", "Gamma", "Invert", "White ink on black paper", "90"})
        CHECK(ui.place(row) == before.at(row));
}

TEST_CASE("another tile and ranking can be chosen from their lists") {
    DotsUi f;
    f.ui.click("Tile");
    f.ui.click("wild64");
    CHECK(f.settings.tile == "wild64");
    f.ui.click("Ranking");
    f.ui.click("farthest point");
    CHECK(f.settings.ranking == RankingMethod::farthest);
}

TEST_CASE("the tile's view has the paper's points in the order of Appendix A") {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::paper);
    for (PlacerKind placer : {PlacerKind::exact, PlacerKind::figure8}) {
        TileView view = view_of("paper16", tile, placer);
        REQUIRE(view.points.size() == 16);
        CHECK(view.points[0].x == doctest::Approx(14217.0 / 65535).epsilon(1e-6));
        CHECK(view.points[0].y == doctest::Approx(2895.0 / 65535).epsilon(1e-6));
        // A quadrant's points, blown up, are points again.
        for (glm::vec2 p : view.points) {
            glm::vec2 blown = glm::fract(p * 2.0f);
            float nearest = 1;
            for (glm::vec2 other : view.points) nearest = std::min(nearest, glm::distance(blown, other));
            CHECK(nearest < 1e-5f);
        }
    }
}

TEST_CASE("the points of a tile of many cells lie where the tile says, first born first") {
    // Two letters to a cell: 64 points in four cells.
    Rule rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
    Tile made = make_tile(rule, {"0301213303211022", "0012", "0013", "0021", "0023", "0031", "0032", "0102",
                                 "0103", "0112", "0113", "0122", "0123"});
    RankedTile tile(made, RankingMethod::farthest);
    TileView view = view_of("many", tile, PlacerKind::exact);
    REQUIRE(view.points.size() == made.size());
    CHECK(view.rule == rule);
    for (BinaryPoint point : made.points) {
        auto is_it = [&](glm::vec2 p) { return glm::distance(p, glm::vec2(to_unit_square(point))) < 1e-5f; };
        CHECK(std::ranges::count_if(view.points, is_it) == 1);
    }
}

TEST_CASE("the tile panel takes points away, and a double-click brings them back") {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    TileView view = view_of("paper16", tile, PlacerKind::exact);
    TilePanelState state;
    auto vertices = [] { return ImGui::GetDrawData()->TotalVtxCount; };
    HeadlessUi ui([&] { draw_tile_panel(view, state); });
    int all = vertices();
    ui.drag("Points shown", 1.0f, 0.0f);
    CHECK(state.shown == 1);
    ui.move_to({1, 899});
    CHECK(vertices() < all - 15 * 24);
    ui.drag("Points shown", 0.0f, 0.5f);
    CHECK(state.shown == doctest::Approx(8).epsilon(0.2));
    ui.drag("Points shown", 0.5f, 1.0f);
    ui.move_to({1, 899});
    CHECK(vertices() == all);
}

TEST_CASE("the letter F is never the same in two orientations") {
    for (Orientation a : all_orientations())
        for (Orientation b : all_orientations()) CHECK((letter_f(a) == letter_f(b)) == (a == b));
}

TEST_CASE("the largest tile fits the panel's draw list") {
    TileView view{"large", {}, {}};
    for (int i = 0; i < 4096; ++i) view.points.push_back((glm::vec2(i % 64, i / 64) + 0.5f) / 64.0f);
    TilePanelState state;
    HeadlessUi ui([&] { draw_tile_panel(view, state); });
    CHECK(ImGui::GetDrawData()->TotalVtxCount > 4096 * 6);
    CHECK(ImGui::GetDrawData()->TotalVtxCount < 65'536);
}

TEST_CASE("a pen's ink is picked") {
    DrawingSettings settings;
    HeadlessUi ui([&] { draw_pen_panel(settings); });
    glm::vec3 before = settings.ink;
    ui.click("Ink");
    // The picker opens beside the pointer; its square of shades is under it, a bit to the right and down.
    ui.frame();
    CHECK(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    CHECK(settings.ink == before);
}

TEST_CASE("pens of one's own begin with those that drew, and are added, named and removed down to one") {
    DrawingSettings settings;
    settings.ink = glm::vec3(0.5f, 0, 0);
    HeadlessUi ui([&] { draw_pen_panel(settings); });
    const auto choose = [&](const char* set) {
        ui.click("Which pens");
        ui.click(set);
    };
    Palette& own = settings.pens.own;
    choose("own");
    REQUIRE(own.size() == 1);
    CHECK(own[0].colour == settings.ink);
    ui.click("Remove Ink");
    CHECK(own.size() == 1);  // greyed: one draws
    own.clear();
    choose("greys");
    choose("own");
    REQUIRE(own.size() == 3);
    ui.click("Add a pen");
    REQUIRE(own.size() == 4);
    CHECK(own[3].name != own[2].name);
    ui.click("Remove Grey");
    REQUIRE(own.size() == 3);
    CHECK(own[1].name == "Black");

    ui.click("Pen 2");
    ui.key(Key::end);
    ui.type("er");
    CHECK(own[1].name == "Blacker");
    ui.type(":");  // would end the name in a file
    CHECK(own[1].name == "Blacker");
    CHECK(ui.has("Refusal"));
    ui.key(Key::escape);
    own[1].name = "Twi";
    ui.frame();
    ui.click("Pen 2");
    ui.key(Key::end);
    own[0].name = "Twin";
    ui.type("n");  // another pen's
    CHECK(own[1].name == "Twi");
    ui.key(Key::escape);
    ui.enter("Width 3, mm", "0.5");
    CHECK(own[2].width_mm == 0.5);
    for (int i = 0; i < 20; ++i) ui.click("Add a pen");
    CHECK(own.size() == kMostPens);
    CHECK(parse_pens(text_of(settings.pens)).own.size() == kMostPens);  // a project has them all
}

TEST_CASE("lengths are shown and typed in inches where that is chosen, and kept in millimetres") {
    ViewerSettings all;
    DrawingSettings& settings = all.drawing;
    HeadlessUi ui([&] {
        draw_dots_panel(settings, {}, all.unit);
        draw_page_panel(settings.page, settings.sheets, {200, 150, 200}, all.unit);
        draw_pen_panel(settings, all.unit);
    });
    ImGui::GetIO().DisplaySize.y = 2000;
    ui.frame();
    ui.enter("Margin, mm", "10");
    CHECK(settings.page.margins.top == 10);
    const DrawingSettings before = settings;
    ui.click("inch");
    CHECK(all.unit == LengthUnit::inch);
    CHECK(settings == before);
    for (const auto& [name, place] : ui.places()) {
        const std::string& label = name;
        CAPTURE(label);
        CHECK(label.find(", mm") == std::string::npos);
    }
    ui.enter("Width, in", "8.5");
    CHECK(settings.page.width_mm == doctest::Approx(215.9));
    ui.enter("Margin, in", "12mm");
    CHECK(settings.page.margins.left == doctest::Approx(12));
    ui.click("fixed");
    ui.enter("Radius, in", "0.01");
    CHECK(settings.dot_size.radius_mm == doctest::Approx(0.254));
    // A page larger than 100 m is refused in inches.
    ui.enter("Width, in", "5000000");
    CHECK(settings.page.width_mm == 100'000);
    CHECK(ui.has("Refusal"));
}

TEST_CASE("the density is one of the method's rows, and its grey a slider that is greyed without it") {
    ViewerSettings settings;
    HeadlessUi ui([&] { draw_method_rows(settings, {kTiles}); });
    CHECK(settings.density == DensityChoice{});
    const WidgetPlace place = ui.place("Grey");
    ui.drag("Grey", 0.5f, 1.0f);
    CHECK(settings.density == DensityChoice{});
    ui.click("ramp");
    CHECK(settings.density.source == DensitySource::ramp);
    ui.click("grey");
    CHECK(settings.density.source == DensitySource::grey);
    CHECK(ui.place("Grey") == place);
    ui.drag("Grey", 0.5f, 1.0f);
    CHECK(settings.density.grey == 1);
    ui.click("photo");
    CHECK(settings.density.source == DensitySource::photograph);
}

TEST_CASE(
    "the split view starts with the paper's tile beside the default one, and the default beside the "
    "paper's") {
    ViewerSettings settings;
    HeadlessUi ui([&] { draw_compare_panel(settings, {kTiles}); });
    ui.click("Right tile");
    CHECK_FALSE(ui.has("wild64"));  // greyed
    const WidgetPlace place = ui.place("Right tile");
    ui.click("Split view");
    CHECK(ui.place("Right tile") == place);
    CHECK(settings.comparison.on);
    CHECK(settings.comparison.tile == "paper16");
    ui.click("same count");
    CHECK(settings.comparison.by == CompareBy::count);
    ui.click("Split view");
    CHECK_FALSE(settings.comparison.on);
    settings.drawing.tile = "paper16";
    ui.click("Split view");
    CHECK(settings.comparison.tile == kDefaultTile);
}

TEST_CASE("Figure 8 on the right side gets a tile that it knows, and says that it cannot count") {
    ViewerSettings settings;
    settings.comparison.on = true;
    settings.comparison.tile = kDefaultTile;
    HeadlessUi ui([&] { draw_compare_panel(settings, {kTiles}); });
    ui.click("Right placer");
    ui.click("Figure 8");
    CHECK(settings.comparison.placer == PlacerKind::figure8);
    CHECK(settings.comparison.tile == "paper16");
    CHECK_FALSE(ui.has("same count"));
    ui.click("similar count");
    CHECK(settings.comparison.by == CompareBy::count);
}

TEST_CASE("the banner stays until its cross is clicked") {
    Banner banner{BannerKind::error, "cat.png: not a picture"};
    HeadlessUi ui([&] { draw_banner(banner, {0, 0}, {400, 300}); });
    for (int i = 0; i < 10; ++i) ui.frame();
    CHECK(banner.message == "cat.png: not a picture");
    ui.click("Close message");
    CHECK(banner.message.empty());
}

TEST_CASE("a notice goes by itself after some seconds, an error does not") {
    Banner notice{BannerKind::notice, "Saved cat.svg"};
    HeadlessUi ui([&] { draw_banner(notice, {0, 0}, {400, 300}); });
    ui.frame(1);
    ui.frame(1);
    CHECK(notice.message == "Saved cat.svg");
    // The window that sleeps wakes when it begins to fade.
    CHECK(seconds_until_change(notice) > 1);
    CHECK(seconds_until_change(notice) < 10);
    for (int second = 0; second < 10; ++second) ui.frame(1);
    CHECK(notice.message.empty());
    notice = {BannerKind::error, "cat.png: not a picture"};
    CHECK(seconds_until_change(notice) > 1e9);
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK(notice.message == "cat.png: not a picture");
}

TEST_CASE("a notice stays while the mouse is on it, and a new one starts anew however long nobody drew") {
    Banner banner{BannerKind::notice, "Saved cat.svg"};
    HeadlessUi ui([&] { draw_banner(banner, {0, 0}, {400, 300}); });
    const glm::vec2 on_it = ui.at("Close message", 0) - glm::vec2(20, 0);
    ui.move_to(on_it);
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK(banner.message == "Saved cat.svg");
    ui.move_to({1, 899});
    banner = {BannerKind::notice, "Saved dog.svg"};
    ui.frame(60);
    CHECK(banner.message == "Saved dog.svg");
}

TEST_CASE("an export's resolution and order are set where it is asked for, for the formats that have them") {
    ViewerSettings settings;
    DrawingFormat format = DrawingFormat::svg;
    ExportInfo info{.dots = 400'000, .bytes = 23.8e6, .trouble = {}};
    HeadlessUi ui([&] { draw_export_panel(settings, format, info); });
    CHECK_FALSE(ui.has("Dots per inch"));
    CHECK_FALSE(ui.has("Finding tone"));
    info.findings = {{FindingKind::tone, "the drawing is paler than the picture", "more dots"},
                     {FindingKind::overlap, "40 % of the dots overlap others", "fewer dots"}};
    ui.frame();
    CHECK(ui.has("Finding tone"));
    CHECK(ui.has("Finding overlap"));
    ui.click("as placed");
    CHECK(settings.saving.order == DotOrder::recursion);
    ui.click("short moves");
    CHECK(settings.saving.order == DotOrder::space);
    ui.click("shortest");
    CHECK(settings.saving.order == DotOrder::shortest);
    ui.click("by priority");
    CHECK(settings.saving.order == DotOrder::priority);
    CHECK(ui.has("Machine"));
    CHECK(ui.has("Plotting time"));
    ui.click("Machine");
    ui.click("iDraw");
    CHECK(settings.saving.machine == Machine::idraw);
    ui.click("Paper in SVG");
    CHECK(settings.drawing.background);
    format = DrawingFormat::gcode;
    ui.frame();
    CHECK_FALSE(ui.has("Paper in SVG"));
    ui.click("laser");
    CHECK(settings.saving.tool == GcodeTool::laser);
    format = DrawingFormat::png;
    ui.frame();
    CHECK_FALSE(ui.has("Dot order"));
    CHECK_FALSE(ui.has("Paper in SVG"));
    ui.enter("Dots per inch", "600");
    CHECK(settings.saving.dpi == 600);
    ui.click("Separations");  // greyed: of several pens only
    CHECK_FALSE(settings.saving.separations);
    settings.drawing.pens.set = PenSet::cmyk;
    ui.click("Separations");
    CHECK(settings.saving.separations);
    format = DrawingFormat::gcode;
    ui.frame();
    ui.click("Pen files");
    CHECK(settings.saving.pen_files);
    format = DrawingFormat::png;
    ui.frame();
    CHECK_FALSE(ui.has("Pen files"));
    settings.drawing.pens.set = PenSet::one;
    ui.click("16");
    CHECK(settings.saving.bits == 16);
    ui.click("8");
    CHECK(settings.saving.bits == 8);
}

TEST_CASE("dots are drawn as lines or in another shape by the pen whose width is typed") {
    DrawingSettings drawing;
    HeadlessUi ui([&] { draw_dots_panel(drawing, {}); });
    ui.click("Dot shape");
    ui.click("spiral");
    CHECK(drawing.mark.shape == DotShape::spiral);
    ui.enter("Pen width, mm", "0.5");
    CHECK(drawing.pen_width_mm == 0.5);
    ui.click("one line");
    CHECK(drawing.style == DrawingStyle::line);
    ui.click("nearest");
    CHECK(drawing.style == DrawingStyle::nearest);
    ui.click("dots");
    CHECK(drawing.style == DrawingStyle::dots);
}

TEST_CASE("several pens are chosen with their width, and then draw registration marks if asked to") {
    DrawingSettings drawing;
    HeadlessUi ui([&] { draw_pen_panel(drawing); });
    ui.click("Registration");  // greyed: of several pens only
    CHECK_FALSE(drawing.registration);
    ui.click("Which pens");
    ui.click("CMYK");
    CHECK(drawing.pens.set == PenSet::cmyk);
    ui.enter("Tip width, mm", "0.4");
    CHECK(drawing.pens.width_mm == 0.4);
    ui.enter("Dot gain, mm", "0.04");
    CHECK(drawing.pens.gain_mm == 0.04);
    ui.enter("Black ink", "0.9");
    CHECK(drawing.pens.black == 0.9);
    ui.click("Registration");
    CHECK(drawing.registration);
    ui.click("Which pens");
    ui.click("own");
    REQUIRE(drawing.pens.own.size() == 4);
    CHECK(drawing.pens.own[0].width_mm == 0.4);
    ui.enter("Width 1, mm", "0.7");
    CHECK(drawing.pens.own[0].width_mm == 0.7);
    ui.enter("Gap 1, mm", "1.5");
    CHECK(drawing.pens.own[0].gap_mm == 1.5);
    CHECK(drawing.pens.own[0].gain_mm == 0.04);
    ui.enter("Gain 1, mm", "0.06");
    CHECK(drawing.pens.own[0].gain_mm == 0.06);
}

TEST_CASE("own pens draw in the order in which they are listed, and change places there") {
    DrawingSettings drawing;
    drawing.pens = parse_pens("Night:#102060,Sand:#d0a040,White:#ffffff");
    HeadlessUi ui([&] { draw_pen_panel(drawing, LengthUnit::mm, {}); });
    const auto names = [&] {
        std::string all;
        for (const Pen& pen : drawing.pens.own) all += pen.name + " ";
        return all;
    };
    ui.click("Draw Sand earlier");  // greyed: the lightest are first
    CHECK(names() == "Night Sand White ");
    ui.click("Pen order");
    ui.click("as listed");
    CHECK(drawing.pens.order == PenOrder::listed);
    ui.click("Draw Night earlier");  // greyed: it is the first
    ui.click("Draw White earlier");
    CHECK(names() == "Night White Sand ");
    ui.click("Remove White");
    CHECK(names() == "Night Sand ");
}

TEST_CASE("a pen is hidden, or looked at alone, and the settings stay as they are") {
    DrawingSettings drawing;
    drawing.pens.set = PenSet::cmyk;
    const DrawingSettings before = drawing;
    Palette pens = palette_of(drawing.pens);
    ShownPens shown;
    HeadlessUi ui([&] { draw_pen_panel(drawing, LengthUnit::mm, {pens, &shown}); });
    CHECK(hidden_among(pens, shown) == 0);
    ui.click("Show Magenta");
    CHECK(hidden_among(pens, shown) == 0b0010);
    // By its name: it stays hidden where the pens come in another order.
    sort_pens(pens, PenOrder::lightest);
    REQUIRE(pens[2].name == "Magenta");
    CHECK(hidden_among(pens, shown) == 0b0100);
    ui.click("Look at");
    ui.click("1 Yellow alone");
    CHECK(hidden_among(pens, shown) == 0b1110);
    ui.click("Show Cyan");  // greyed: one pen is looked at alone
    CHECK(hidden_among(pens, shown) == 0b1110);
    pens.erase(pens.begin());  // without it, there are all again that are not hidden
    ui.frame();
    CHECK(hidden_among(pens, shown) == 0b010);
    ui.click("Show Magenta");
    CHECK(hidden_among(pens, shown) == 0);
    CHECK(drawing == before);
}

TEST_CASE("what is wrong with an export is mended by a click, where there is one way to mend it") {
    ViewerSettings settings;
    settings.drawing.show_tiles = true;
    settings.drawing.page.margins = {0, 7, 0, 0};
    ExportInfo info{.dots = 400, .bytes = 1e4, .trouble = {}};
    info.findings = {{FindingKind::hours, "plotting takes long", "8,400 dots take an hour", 8400},
                     {FindingKind::overlap, "dots overlap", "fewer part them"},
                     {FindingKind::joined, "dots are joined", "fewer part them"},
                     {FindingKind::over_edge, "dots reach over", "a margin helps", 0.4},
                     {FindingKind::fine_pixels, "dots are fine", "more pixels show them", 720},
                     {FindingKind::tile_layer, "the layer is drawn", "leave it out"},
                     {FindingKind::rings, "rings are drawn", "spirals fill them"}};
    HeadlessUi ui([&] { draw_export_panel(settings, DrawingFormat::svg, info); });
    ui.click("8,400 dots");
    CHECK(settings.drawing.placing.count == 8400);
    ui.click("Black 0.7");
    CHECK(settings.drawing.tone.black == 0.7);
    ui.frame();
    CHECK_FALSE(ui.has("Black 0.7"));  // it would change nothing
    ui.click("Margins of 0.4 mm");
    CHECK(settings.drawing.page.margins == Margins{0.4, 7, 0.4, 0.4});
    ui.click("720 dots per inch");
    CHECK(settings.saving.dpi == 720);
    ui.click("Leave the tile boundaries out");
    CHECK_FALSE(settings.drawing.show_tiles);
    ui.click("Fill the dots with spirals");
    CHECK(settings.drawing.mark.shape == DotShape::spiral);
}

TEST_CASE("a G-code template of one's own is named by its file, and what it says is taken over") {
    const TemporaryFolder folder;
    const std::string name = (folder / "own").string(), says = "move G1 X{x} Y{y}\ndot G4 P{dwell}\n";
    put_text(name, says);
    put_text(name + "x", "this is no template");
    ViewerSettings settings;
    HeadlessUi ui([&] {
        draw_export_panel(settings, DrawingFormat::gcode, {.dots = 400, .bytes = 1e4, .trouble = {}});
    });
    SavingChoice& saving = settings.saving;
    ui.click("Template");  // greyed: nothing happens
    ui.type(name.c_str());
    CHECK(saving == SavingChoice{});
    ui.click("servo");
    ui.click("own");
    CHECK(saving.gcode_template.text == gcode_template_of(GcodeTool::servo));  // until a file is named
    ui.click("Template");
    ui.type((name + "x").c_str());
    CHECK(ui.has("Refusal"));
    CHECK(saving.gcode_template.file.empty());
    ui.key(Key::backspace);
    CHECK(saving.gcode_template == OwnTemplate{says, name});
    ui.enter("Feed, mm/min", "1234");
    ui.enter("Dwell, s", "0.5");
    CHECK(saving.feed_mm_per_min == 1234);
    CHECK(saving.dwell_s == 0.5);
    ui.enter("Accel., mm/s2", "750");
    CHECK(saving.acceleration_mm_per_s2 == 750);
    CHECK(gcode_style_of(saving).lines == parse_gcode_template(says));
    ui.enter("Pen down", "75");
    CHECK(saving.pen_down == 75);
    ui.enter("Laser power", "800");
    CHECK(saving.laser_power == 800);
    ui.click("laser");
    CHECK(saving.gcode_template == OwnTemplate{});
    CHECK(saving.tool == GcodeTool::laser);
    CHECK_FALSE(saving.pen_down);  // a servo's
}

TEST_CASE("a dot's own path is typed: what is none is told and changes nothing") {
    DrawingSettings drawing;
    drawing.mark.shape = DotShape::path;
    drawing.mark.path = "M0,0 L1,1";
    HeadlessUi ui([&] { draw_dots_panel(drawing, {}); });
    ui.click("Own shape");
    ui.key(Key::end);
    ui.type(" L9,9");
    CHECK(drawing.mark.path == "M0,0 L1,1");
    CHECK(ui.has("Refusal"));
    for (int i = 0; i < 3; ++i) ui.key(Key::backspace);
    ui.type("1,0");
    CHECK(drawing.mark.path == "M0,0 L1,1 L1,0");
    CHECK_FALSE(ui.has("Refusal"));
}

TEST_CASE("a file's size is told in round words") {
    CHECK(size_in_words({.dots = 400'000, .bytes = 23.8e6, .trouble = {}}) == "about 24 MB, 400,000 dots");
    CHECK(size_in_words({.dots = 1, .bytes = 500, .trouble = {}}) == "about 0.5 kB, 1 dot");
    CHECK(size_in_words({.dots = 10, .bytes = 1.26e9, .trouble = {}}) == "about 1.3 GB, 10 dots");
    CHECK(size_in_words({.dots = 10, .bytes = 999.9e3, .trouble = {}}) == "about 1.0 MB, 10 dots");
}

TEST_CASE("saving can be cancelled by its button, and by nothing else") {
    int cancelled = 0;
    HeadlessUi ui([&] {
        cancelled += draw_saving_banner("a long name of a file.svg", 0.4, {0, 0}, {400, 300});
    });
    ui.move_to({100, 270});
    ui.press();
    ui.release();
    CHECK(cancelled == 0);
    ui.click("Cancel saving");
    CHECK(cancelled == 1);
}

TEST_CASE("the status line says dots as people write them, and Figure 8's duplicates") {
    CHECK(dots_in_words({.dots = 1'234'567}) == "1,234,567 dots");
    CHECK(dots_in_words({.dots = 1}) == "1 dot");
    CHECK(dots_in_words({.dots = 54'608, .duplicates = 13'648, .figure8 = true}) ==
          "54,608 dots, 13,648 of them duplicates (25 %)");
    CHECK(dots_in_words({.figure8 = true}) == "0 dots, 0 of them duplicates (0 %)");
}

TEST_CASE("the status line says that a placing takes long, and how long the last one took otherwise") {
    const auto says = [](double seconds, const std::string& words) {
        const auto items =
            status_items({.dots = 5, .place_ms = 12.34, .placing_seconds = seconds, .method = true});
        return std::ranges::any_of(items, [&](const StatusItem& item) { return item.text == words; });
    };
    CHECK(says(0, "placing 12.3 ms"));
    CHECK(says(0.2, "placing 12.3 ms"));
    CHECK(says(0.8, "placing, 1 s, Escape stops it"));
    CHECK_FALSE(says(0.8, "placing 12.3 ms"));
}

TEST_CASE("a placing that takes long shows its share, in words and as a bar, and so does what settles") {
    StatusInfo facts{.placing_seconds = 0.4, .placed_share = 0.25};
    HeadlessUi ui([&] { draw_status_line({0, 500}, {400, 30}, facts); });
    const auto says = [&](const std::string& words) {
        return std::ranges::any_of(status_items(facts),
                                   [&](const StatusItem& item) { return item.text == words; });
    };
    CHECK_FALSE(ui.has("Progress"));  // not long yet
    facts.placing_seconds = 0.6;
    ui.frame();
    CHECK(says("placing, 25 %, Escape stops it"));
    CHECK(ui.place("Progress").max.x == 100);
    facts.steps = 3;
    facts.all_steps = 4;
    ui.frame();
    CHECK(says("settling, step 3 of 4, Escape stops it"));
    CHECK(ui.place("Progress").max.x == 300);
    facts = {.placing_seconds = 0.6};  // Figure 8's come at once
    ui.frame();
    CHECK_FALSE(ui.has("Progress"));
    CHECK(says("placing, 1 s, Escape stops it"));
}

TEST_CASE("the status line tells dots, paper and zoom; scale and times only where the method is looked at") {
    StatusInfo facts{.dots = 40'000, .scale = 2500, .tone_ms = 1, .place_ms = 3, .draw_ms = 2, .zoom = 0.68};
    const auto words = [&] {
        std::string all;
        for (const StatusItem& item : status_items(facts)) all += item.text + "; ";
        return all;
    };
    CHECK(words() == "40,000 dots; 68 %; ");
    facts.as_dense_as = 2.56e6;
    CHECK(words() == "40,000 dots, here as dense as 2.56 million; 68 %; ");
    facts.as_dense_as = 0;
    facts.paper = paper_in_words({210, 297, 297}, LengthUnit::mm);
    CHECK(words() == "40,000 dots; 210 x 297 mm; 68 %; ");
    CHECK(paper_in_words({215.9, 279.4, 279.4}, LengthUnit::inch) == "8.5 x 11 in");
    facts.paper.clear();
    facts.method = true;
    CHECK(words().starts_with("40,000 dots; 68 %; scale 2,500; tone 1.0 ms; "));
    CHECK(words().find("drawing 2.0 ms") != std::string::npos);
}

TEST_CASE("a narrow status line keeps the number of dots and lets the rest go, the least important first") {
    const StatusInfo facts{
        .dots = 40'000, .scale = 2500, .tone_ms = 1, .frames_per_second = 60, .method = true};
    HeadlessUi ui([] {});
    std::size_t before = 0;
    for (const float width : {10.0f, 250.0f, 400.0f, 2000.0f}) {
        const auto items = fitting(status_items(facts), width);
        CHECK(items.size() > before);
        before = items.size();
        CHECK(items.front().text == "40,000 dots");
        float needed = 0;
        for (const StatusItem& item : items) needed += ImGui::CalcTextSize(item.text.c_str()).x;
        if (items.size() > 1) CHECK(needed < width);
    }
    CHECK(before == status_items(facts).size());
    const auto two = fitting(status_items(facts), 200);
    REQUIRE(two.size() == 2);
    CHECK(two.back().text == "100 %");
}

TEST_CASE("every panel fits its column without cutting a label") {
    ViewerSettings settings;
    HeadlessUi ui([&] {
        draw_tone_panel(settings.drawing, {});
        draw_dots_panel(settings.drawing, {});
        draw_page_panel(settings.drawing.page, settings.drawing.sheets, {200, 150, 200}, settings.unit);
        draw_method_rows(settings, {kTiles});
        draw_compare_panel(settings, {kTiles});
    });
    settings.comparison.on = true;
    ImGui::GetIO().DisplaySize.x = 340;
    ui.frame();
    ui.frame();
    for (const char* label : {"Black point", "White point", "Contrast", "Brightness", "Gamma", "Blur", "Dots",
                              "Orientation", "Sheets across", "Right placer"}) {
        CAPTURE(label);
        float start = ImGui::GetStyle().WindowPadding.x;
        CHECK(start + ImGui::CalcTextSize(label).x < ui.place(label).min.x);
        CHECK(ui.place(label).max.x < 340);
    }
}

TEST_CASE("a tile that is not in the list is shown all the same, a file without its folders") {
    std::string tile = "/home/me/mine.tile";
    HeadlessUi ui([&] { tile_row("Tile", tile, {kTiles}, "Which."); });
    ui.click("Tile");
    CHECK(ui.has("paper16"));
    CHECK_FALSE(ui.has("/home/me/mine.tile"));
    CHECK_FALSE(ui.has("From a file..."));
    ui.click("mine.tile");
    CHECK(tile == "/home/me/mine.tile");
    tile = "14217,2895/16";
    ui.click("Tile");
    CHECK(ui.has("14217,2895/16"));
    ui.click("wild64");
    CHECK(tile == "wild64");
}

TEST_CASE("of two tile files of the same name the list shows the whole paths") {
    const std::array<std::string, 3> tiles{"paper16", "/a/mine.tile", "/b/mine.tile"};
    std::string tile = "paper16";
    HeadlessUi ui([&] { tile_row("Tile", tile, {tiles}, "Which."); });
    ui.click("Tile");
    ui.click("/b/mine.tile");
    CHECK(tile == "/b/mine.tile");
}

TEST_CASE("the last entry of the tiles asks for a file and leaves the tile as it is") {
    int asked = 0;
    ViewerSettings all;
    DrawingSettings& settings = all.drawing;
    settings.tile = "paper16";
    const DrawingSettings before = settings;
    HeadlessUi ui([&] { draw_method_rows(all, {kTiles, [&] { ++asked; }}); });
    ui.click("Tile");
    CHECK(asked == 0);
    ui.click("From a file...");
    CHECK(asked == 1);
    CHECK(settings == before);
    ui.click("Tile");
    ui.click("wild64");
    CHECK(asked == 1);
    CHECK(settings.tile == "wild64");
}

TEST_CASE("the crop's rows are percent of the picture, keep a rest of it, and all of it is no crop") {
    std::optional<Crop> crop;
    bool framing = false;
    HeadlessUi ui([&] { draw_crop_rows(crop, {400, 200}, framing); });
    ui.click("Crop");
    ui.click("Crop frame");
    CHECK(framing);
    ui.enter("From left, %", "25");
    REQUIRE(crop);
    CHECK(crop->unit == Crop::Unit::percent);
    CHECK(crop->box == Rectangle<double>{{25, 0}, {100, 100}});
    ui.enter("To right, %", "10");  // left of the left side
    CHECK(crop->box.high.x > crop->box.low.x);
    ui.enter("To right, %", "100");
    ui.enter("From left, %", "0");
    CHECK_FALSE(crop);
    crop = Crop{{{100, 50}, {300, 150}}, Crop::Unit::pixels};
    ui.enter("From top, %", "50");
    CHECK(crop->box == Rectangle<double>{{25, 50}, {75, 75}});
    ui.click("Crop");
    CHECK_FALSE(framing);
}

TEST_CASE("the method's rows show tiles, colour dots, let new ones come in and leave levels out") {
    ViewerSettings settings;
    HeadlessUi ui([&] { draw_method_rows(settings, {kTiles}); });
    ui.click("Tile boundaries");
    CHECK(settings.drawing.show_tiles);
    ui.click("more dots");
    CHECK(settings.zoom_mode == ZoomMode::constant_density);
    ui.click("Dots coloured");
    ui.click("by rank");
    CHECK(settings.colouring == DotColouring::rank);
    ui.drag("Divided up to", 1.0f, 0.0f);
    CHECK(settings.deepest_level == 0);
    ui.drag("Divided up to", 0.0f, 1.0f);
    CHECK(settings.deepest_level == kDeepestStep);
    ui.click("Every frame");
    CHECK(settings.every_frame);
}

}  // namespace dapple
