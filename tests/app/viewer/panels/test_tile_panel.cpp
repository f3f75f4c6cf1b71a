// The tile in the window: its rows, its picture, its list. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <string>

#include "app/viewer/panels/method_panels.h"
#include "core/tile/tile.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

const std::array<std::string, 2> kTiles{"paper16", "wild64"};

}  // namespace

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
    std::size_t shown = SIZE_MAX;
    auto vertices = [] { return ImGui::GetDrawData()->TotalVtxCount; };
    HeadlessUi ui([&] { draw_tile_panel(view, shown); });
    int all = vertices();
    ui.drag("Points shown", 1.0f, 0.0f);
    CHECK(shown == 1);
    ui.move_to({1, 899});
    CHECK(vertices() < all - 15 * 24);
    ui.drag("Points shown", 0.0f, 0.5f);
    CHECK(shown == doctest::Approx(8).epsilon(0.2));
    ui.drag("Points shown", 0.5f, 1.0f);
    ui.move_to({1, 899});
    CHECK(vertices() == all);
}

TEST_CASE("the letter F is never the same in two orientations") {
    for (Orientation a : all_orientations())
        for (Orientation b : all_orientations()) CHECK((letter_f(a) == letter_f(b)) == (a == b));
}

TEST_CASE("a tile of several kinds has a legend of all of them, eight in a row") {
    TileView view{"ten", {}, {glm::vec2(0.5f)}, {}, NextKinds(10, {0, 3, 9, 1})};
    std::size_t shown = SIZE_MAX;
    HeadlessUi ui([&] { draw_tile_panel(view, shown); });
    for (int k = 0; k < 10; ++k) CHECK(ui.has("Kind " + std::to_string(k)));
    CHECK_FALSE(ui.has("Kind 10"));
    CHECK(ui.place("Kind 7").min.x > ui.place("Kind 0").max.x);
    CHECK(ui.place("Kind 8").min.y > ui.place("Kind 0").max.y);
    CHECK(ui.place("Kind 8").min.x == ui.place("Kind 0").min.x);

    view.next_kind = NextKinds(1);
    ui.move_to({1, 899});
    CHECK_FALSE(ui.has("Kind 0"));
}

TEST_CASE("the largest tile fits the panel's draw list") {
    TileView view{"large", {}, {}};
    for (int i = 0; i < 4096; ++i) view.points.push_back((glm::vec2(i % 64, i / 64) + 0.5f) / 64.0f);
    std::size_t shown = SIZE_MAX;
    HeadlessUi ui([&] { draw_tile_panel(view, shown); });
    CHECK(ImGui::GetDrawData()->TotalVtxCount > 4096 * 6);
    CHECK(ImGui::GetDrawData()->TotalVtxCount < 65'536);
}

TEST_CASE("the density is one of the method's rows, and its grey a slider that is there with it") {
    ViewerSettings settings;
    HeadlessUi ui([&] { draw_method_rows(settings, {kTiles}); });
    CHECK(settings.density == DensityChoice{});
    ui.click("ramp");
    CHECK_FALSE(ui.has("Grey"));
    CHECK(settings.density.source == DensitySource::ramp);
    ui.click("grey");
    CHECK(settings.density.source == DensitySource::grey);
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
    CHECK_FALSE(ui.has("Right tile"));
    ui.click("Split view");
    CHECK(ui.has("Right tile"));
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
