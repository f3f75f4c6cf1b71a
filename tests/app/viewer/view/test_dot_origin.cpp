// What the card beside the pointer says of a dot, against all points of all tiles of some levels, each put
// where the tile's definition says, and so are the root tiles before the one at the given corner.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/workbench.h"
#include "app/viewer/canvas/loupe.h"
#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/view/dot_origin.h"
#include "core/placing/page.h"
#include "io/files/tile_library.h"
#include "tests/dot_pieces.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

struct DefinedPoint {
    glm::dvec2 at;
    int level, rank;
    glm::dvec2 corner;
    Orientation orientation;
};

struct TurnedTile {
    Tile tile;
    Ranking ranking;
    std::vector<Newborn> newborns;
    std::vector<DefinedPoint> points;

    TurnedTile(int levels, glm::dvec2 root) {
        Rule rule;
        for (std::size_t q = 0; q < 4; ++q) rule.child[q].index = static_cast<std::uint8_t>(q + 2);
        tile = make_tile(rule, {"0301", "2213"});
        ranking = rank(tile, RankingMethod::farthest);
        newborns = newborns_of(tile);
        for (const glm::dvec2 whole : {glm::dvec2(-1, -1), {0, -1}, {-1, 0}, {0, 0}}) {
            const glm::dvec2 corner = root + whole;
            for (std::size_t i = 0; i < tile.size(); ++i)
                points.push_back({corner + to_unit_square(tile.points[i]),
                                  0,
                                  static_cast<int>(ranking.tile[i]),
                                  corner,
                                  {}});
            divide(corner, 0, {}, levels);
        }
    }

    void divide(glm::dvec2 corner, int level, Orientation turned, int levels) {
        if (level == levels) return;
        const double side = std::ldexp(1.0, -level);
        const auto child_corner = [&](int q) {
            const int there = apply_to_quadrant(turned, q);
            return corner + side / 2 * glm::dvec2(there & 1, there >> 1);
        };
        for (std::size_t i = 0; i < newborns.size(); ++i) {
            const Newborn& born = newborns[i];
            const auto q = static_cast<std::size_t>(born.quadrant);
            points.push_back({corner + side * to_unit_square(apply(turned, born.position)), level + 1,
                              static_cast<int>(ranking.newborn[i]) - static_cast<int>(tile.size()),
                              child_corner(born.quadrant), compose(turned, tile.rule.child[q])});
        }
        for (int q = 0; q < 4; ++q)
            divide(child_corner(q), level + 1, compose(turned, tile.rule.child[static_cast<std::size_t>(q)]),
                   levels);
    }
};

}  // namespace

TEST_CASE(
    "the card tells of each dot the level, rank, tile, density and critical scale that the tile's "
    "definition gives it") {
    constexpr int kLevels = 4;
    Grid<float> corners(2, 2);
    corners.values = {0.2f, 0.4f, 0.6f, 0.9f};
    for (const Density& ramp : {Density(corners), page_density(corners)}) {
        const TurnedTile made(kLevels, ramp.tile_corner());
        RankedTile tile(made.tile, made.ranking);
        PlacedDrawing drawing;
        drawing.tile_corner = ramp.tile_corner();
        tile.placer().place(ramp, {.scale = 100, .thresholds = true}, drawing.dots);
        drawing.blocks = dot_blocks(drawing.dots);
        const PlacedWith with{made.tile.size(), made.tile.rule};
        const Dots dots = joined(drawing.dots);
        REQUIRE(dots.size() > 500);
        std::size_t found = 0;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 at(dots.x[i], dots.y[i]);
            const DefinedPoint* expected = nullptr;
            for (const DefinedPoint& each : made.points)
                if (glm::distance(each.at, at) < 1e-6) expected = &each;
            REQUIRE(expected);
            // The pointer is a little beside it.
            const auto dot = dot_under(drawing, with, page_point(at + glm::dvec2(1e-5, -1e-5)), 1e-3);
            REQUIRE(dot);
            REQUIRE(dot->tile);
            found += dot->position == at && dot->level == expected->level && dot->rank == expected->rank &&
                     dot->born == (dot->level == 0 ? 8 : 24) &&
                     glm::distance(glm::dvec2(dot->tile->x, dot->tile->y), expected->corner) < 1e-12 &&
                     dot->tile->orientation == expected->orientation;
            const double density = ramp.at(at);
            CHECK(dot->density == doctest::Approx(density).epsilon(1e-4));
            const double ranks =
                dot->level == 0 ? dot->rank + 0.5 : (8 + dot->rank + 0.5) * std::pow(4, dot->level - 1);
            CHECK(dot->critical == doctest::Approx(ranks / 16 / density).epsilon(1e-4));
        }
        CHECK(found == dots.size());
        CHECK_FALSE(dot_under(drawing, with, page_point({1.5, 0.5}), 0.1));
    }
}

TEST_CASE("of a relaxed dot the card tells the tile that it was placed in, whatever tile it lies in now") {
    int elsewhere = 0;
    Workbench bench;
    // Its dots are placed, and relaxed as well; few of them appear at the same scale.
    Grid<float> light(30, 20);
    for (std::size_t i = 0; i < light.values.size(); ++i) light.values[i] = 0.1f + 0.001f * float(i);
    bench.set_picture({.light = light});
    for (const auto& [name, source] : {std::pair{"aperiodic64", DensitySource::ramp},
                                       {"aperiodic4096", DensitySource::ramp},
                                       {"aperiodic4096", DensitySource::photograph}}) {
        CAPTURE(name);
        const PlacerKind placer = PlacerKind::exact;
        ViewerSettings settings;
        settings.drawing.tile = name;
        settings.drawing.placer = placer;
        settings.drawing.placing.count = 6000;
        settings.drawing.tone_strength = 1;  // what is light has the same density for dots of any evenness
        settings.density.source = source;
        settings.origins = true;
        RankedTile tile = tile_named(name);
        const TileView view = view_of(name, tile, placer);
        const PlacedWith with{tile.tile().size(), placer == PlacerKind::exact ? view.rule : Rule{}, placer,
                              view.points, view.newborn};
        PlacedDrawing placed, relaxed;
        for (PlacedDrawing* drawing : {&placed, &relaxed}) {
            settings.drawing.relax = drawing == &placed ? 0 : 10;
            REQUIRE(bench.place(dots_request(settings), *drawing));
            drawing->blocks = dot_blocks(drawing->dots);
        }
        const auto all_of = [&](const PlacedDrawing& drawing) {
            std::multimap<std::pair<float, float>, DotOrigin> all;
            const Dots dots = joined(drawing.dots);
            for (std::size_t i = 0; i < dots.size(); ++i) {
                const auto dot = dot_under(drawing, with, page_point({dots.x[i], dots.y[i]}), 1e-7);
                REQUIRE(dot);
                all.insert({{dots.threshold[i], dots.critical[i]}, *dot});
            }
            return all;
        };
        const auto before = all_of(placed);
        int alone = 0, found = 0;
        for (const auto& [key, dot] : all_of(relaxed)) {
            if (before.count(key) != 1) continue;
            const DotOrigin& origin = before.find(key)->second;
            ++alone;
            REQUIRE(dot.tile);
            found += dot.tile->x == origin.tile->x && dot.tile->y == origin.tile->y &&
                     dot.tile->side == origin.tile->side && dot.tile->orientation == origin.tile->orientation;
            const glm::dvec2 in_tile = (dot.position - glm::dvec2(dot.tile->x, dot.tile->y)) / dot.tile->side;
            elsewhere += in_tile.x < 0 || in_tile.y < 0 || in_tile.x > 1 || in_tile.y > 1;
        }
        CHECK(alone > 50);
        CHECK(found == alone);
    }
    CHECK(elsewhere > 0);
}

TEST_CASE("of a relaxed dot no tile is made up, and without thresholds nothing is said") {
    PlacedDrawing drawing;
    Dots one;
    one.resize(1, true);
    one.x[0] = one.y[0] = 0.5f;
    one.threshold[0] = 4.5f / 16 * 4;  // rank 4 at level 2 of a tile of 4 points: the first newborn one
    one.critical[0] = one.threshold[0] / 0.25f;
    drawing.dots = in_one_piece(std::move(one));
    drawing.blocks = dot_blocks(drawing.dots);
    drawing.steps = 3;
    const PlacedWith with{4, {}};
    auto dot = dot_under(drawing, with, page_point({0.5, 0.51}), 0.1);
    REQUIRE(dot);
    CHECK(dot->level == 2);
    CHECK_FALSE(dot->tile);
    const auto words = origin_in_words(*dot, with, 7);
    CHECK(words.front() == "Level 2, 1st of 12");
    CHECK(words.back() == "Moved by relaxation; tile unknown");
    drawing.steps = 0;
    dot = dot_under(drawing, with, page_point({0.5, 0.51}), 0.1);
    REQUIRE(dot);
    CHECK(dot->tile);
    CHECK(dot->density == doctest::Approx(0.25));
    drawing.dots.pieces[0].threshold.clear();
    CHECK_FALSE(dot_under(drawing, with, page_point({0.5, 0.51}), 0.1));
}

TEST_CASE("with the switch every dot of the window's drawing can be explained, with or without relaxing") {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(40, 30, 0.3f)});
    for (const int steps : {0, 2}) {
        CAPTURE(steps);
        ViewerSettings settings;
        settings.drawing.placing.count = 500;
        settings.drawing.relax = steps;
        settings.origins = true;
        PlacedDrawing drawing;
        REQUIRE(bench.place(dots_request(settings), drawing));
        drawing.blocks = dot_blocks(drawing.dots);
        const Dots dots = joined(drawing.dots);
        REQUIRE(dots.size() == 500);
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const auto dot = dot_under(drawing, {}, page_point({dots.x[i], dots.y[i]}), 1e-6);
            REQUIRE(dot);
            CHECK(dot->tile.has_value() == (steps == 0));
        }
    }
}

TEST_CASE("where nothing of the page is in view, the pointer is on no dot, however far away it is") {
    constexpr std::int64_t kPage = std::int64_t{1} << 62;
    constexpr auto kFurthest = std::numeric_limits<std::int64_t>::min();
    Workbench bench;
    bench.set_picture({.light = Grid<float>(40, 30, 0.3f)});
    ViewerSettings settings;
    settings.origins = true;
    PlacedDrawing drawing;
    REQUIRE(bench.place(dots_request(settings), drawing));
    drawing.blocks = dot_blocks(drawing.dots);
    for (const std::int64_t corner : {std::int64_t{0}, kPage}) {
        drawing.plan.placing.window.x = drawing.plan.placing.window.y = corner;
        CHECK_FALSE(dot_under(drawing, {}, {kFurthest, kFurthest}, 1e-3));
    }
}

TEST_CASE("zoomed in as far as it goes, a dot is explained still") {
    PlacedDrawing drawing;
    drawing.plan.size = {.sizing = DotSizing::fixed, .radius_mm = 0.01};
    drawing.plan.page.mm_per_page_unit = drawing.layout.page.mm_per_page_unit = 1;
    Dots dots;
    dots.x = {0.5f};
    dots.y = {0.5f};
    dots.threshold = dots.critical = {7.5f};
    drawing.dots = split(dots);
    drawing.blocks = dot_blocks(drawing.dots);
    const CanvasPlace place{.size = {400, 900}};
    Camera camera{.canvas = place.size, .centre = page_point({0.5, 0.5}), .pixels_per_unit = 500};
    HeadlessUi ui([&] {
        ImGui::GetIO().WantCaptureMouse = false;  // the panel of this test covers all
        draw_dot_card(drawing, {}, camera, place);
    });
    ui.move_to({200, 450});
    for (; camera.pixels_per_unit < kLargestZoom; camera.pixels_per_unit *= 2) {
        ui.frame();
        REQUIRE(dot_under(drawing, {}, camera.centre, drawing.dot_radius()));
    }
}

}  // namespace dapple
