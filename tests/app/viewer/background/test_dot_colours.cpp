// The colours that tell where in the subdivision a dot comes from.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/workbench.h"
#include "core/image/colour.h"
#include "core/placing/page.h"
#include "io/files/tile_library.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

namespace dapple {
namespace {

// A drawing on grey by a tile whose children are turned, and the tiles it went through.
struct Turned {
    explicit Turned(const NextKinds& next_kind = NextKinds(1)) {
        Rule rule;
        for (int q = 0; q < 4; ++q) rule.child[q].index = static_cast<std::uint8_t>(q + 2);
        const bool kinds = next_kind.size() > 1;
        RankedTile tile(kinds ? random_kinds(rule, next_kind, 64, 2) : make_tile(rule, {"0301", "2213"}),
                        kinds ? RankingMethod::energy : RankingMethod::farthest);
        const Density grey = page_density(Grid<float>(1, 1, 0.5f));
        const PlacingRequest request{.scale = 300, .thresholds = true};
        DotPieces placed;
        tile.placer().place(grey, request, placed);
        dots = joined(placed);
        // A tile is listed once it has children: the dots' own tiles are those of a scale one level finer.
        tiles = placed_tiles(tile.placer().table(), grey, {.scale = 4 * request.scale});
        origins = {.tile_size = tile.tile().size(), .rule = rule, .window = {}, .next_kind = next_kind};
        origins.tile_corner = grey.tile_corner();
    }
    DotPieces pieces() const { return split(dots); }

    Dots dots;
    std::vector<PlacedTile> tiles;
    DotOrigins origins;
};

// Calls look(number of a dot, the tile of the dot's level that it lies in).
template <typename Look>
void for_each_tile_around(const Turned& drawing, const Look& look) {
    for (std::size_t i = 0; i < drawing.dots.size(); ++i) {
        const double x = drawing.dots.x[i], y = drawing.dots.y[i];
        const int level = tile_rank_of(drawing.dots.threshold[i], drawing.origins.tile_size).level;
        for (const PlacedTile& tile : drawing.tiles)
            if (tile.level == level && x >= tile.x && y >= tile.y && x < tile.x + tile.side &&
                y < tile.y + tile.side)
                look(i, tile);
    }
}

glm::u8vec3 rgb8(glm::vec3 colour) {
    return glm::u8vec3(glm::round(colour * 255.0f));
}

}  // namespace

TEST_CASE("ink needs no colours") {
    CHECK(dot_colours(Turned().pieces(), {}, DotColouring::ink).empty());
}

TEST_CASE("a dot has the colour of the orientation of the tile around it at its level") {
    const Turned drawing;
    const auto colours = dot_colours(drawing.pieces(), drawing.origins, DotColouring::orientation);
    REQUIRE(colours.size() == drawing.dots.size());
    int wrong = 0, found = 0;
    std::set<int> seen;
    for_each_tile_around(drawing, [&](std::size_t dot, const PlacedTile& tile) {
        ++found;
        seen.insert(tile.orientation.index);
        wrong += rgb8(orientation_colour(tile.orientation)) != glm::u8vec3(colours[dot]);
        CHECK_FALSE(tile.kind);
    });
    CHECK(found == static_cast<int>(colours.size()));
    CHECK(wrong == 0);
    CHECK(seen.size() >= 6);
}

TEST_CASE("of a tile of several kinds, a dot has the colour of the kind of the tile around it") {
    RankedTile tile(random_kinds(Rule{}, kThreeKinds, 64, 2), RankingMethod::energy);
    const PlacingRequest request{.scale = 300, .thresholds = true};
    Stippling placed;
    REQUIRE(stipple(tile, Density(Grid<float>(1, 1, 1.0f)), PlacerKind::exact, request, placed));
    const auto colours =
        dot_colours(placed.dots, {64, Rule{}, PageWindow{}, kThreeKinds}, DotColouring::orientation);
    REQUIRE(colours.size() == placed.dots.size());
    int wrong = 0;
    std::set<std::size_t> seen;
    std::size_t i = 0;
    for (const Dots& piece : placed.dots.pieces) {
        for (std::size_t k = 0; k < piece.size(); ++k, ++i) {
            double x = piece.x[k], y = piece.y[k];
            std::size_t kind = 0;
            for (int level = tile_rank_of(piece.threshold[k], 64).level; level > 0; --level) {
                const bool right = x >= 0.5, below = y >= 0.5;
                kind = kThreeKinds[kind][(right ? 1 : 0) + (below ? 2 : 0)];
                x = 2 * x - right;
                y = 2 * y - below;
            }
            seen.insert(kind);
            wrong += rgb8(kind_colour(kind)) != glm::u8vec3(colours[i]);
        }
    }
    CHECK(wrong == 0);
    CHECK(seen.size() == 3);
}

TEST_CASE("tiles have the kinds that their dots have the colours of") {
    const Turned drawing(kThreeKinds);
    const auto colours = dot_colours(drawing.pieces(), drawing.origins, DotColouring::orientation);
    std::set<std::size_t> seen;
    for_each_tile_around(drawing, [&](std::size_t dot, const PlacedTile& tile) {
        REQUIRE(tile.kind);
        seen.insert(*tile.kind);
        CHECK(rgb8(kind_colour(*tile.kind)) == glm::u8vec3(colours[dot]));
    });
    CHECK(seen.size() == 3);
}

TEST_CASE("hues of kinds differ, and are dark enough for paper") {
    for (std::size_t a = 0; a < 16; ++a) {
        for (std::size_t b = 0; b < a; ++b) CHECK(glm::distance(kind_colour(a), kind_colour(b)) > 0.05f);
        const glm::vec3 c = kind_colour(a);
        CHECK(std::min({c.r, c.g, c.b}) < 0.2f);
    }
}

TEST_CASE("a dot has its level's colour, and the first of its level is darker than the last") {
    const Turned drawing;
    const auto levels = dot_colours(drawing.pieces(), drawing.origins, DotColouring::level);
    const auto ranks = dot_colours(drawing.pieces(), drawing.origins, DotColouring::rank);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const TileRank at = tile_rank_of(drawing.dots.threshold[i], drawing.origins.tile_size);
        CHECK(glm::u8vec3(levels[i]) == rgb8(level_colour(at.level)));
        if (at.level == 0 && at.rank == 0) CHECK(glm::u8vec3(ranks[i]) == rgb8(rank_colour(0)));
    }
    const auto lightness = [](glm::vec3 c) { return c.r + c.g + c.b; };
    for (double share = 0; share < 1; share += 0.125)
        CHECK(lightness(rank_colour(share)) < lightness(rank_colour(share + 0.125)));
}

TEST_CASE("a dot of a window deep in the page has the colour it has on the page") {
    const Turned drawing;
    const std::int64_t quarter = std::int64_t{1} << 60;
    Dots moved = drawing.dots;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        moved.x[i] -= 0.25f;
        moved.y[i] -= 0.25f;
    }
    DotOrigins origins = drawing.origins;
    origins.window = {.x = quarter, .y = quarter, .width = 0.75, .height = 0.75};
    const auto here = dot_colours(drawing.pieces(), drawing.origins, DotColouring::orientation);
    const auto there = dot_colours(in_one_piece(moved), origins, DotColouring::orientation);
    CHECK(here == there);
}

TEST_CASE("up to a level just the dots born until then are shown") {
    const Turned drawing;
    const std::size_t n = drawing.origins.tile_size;
    std::size_t before = 0;
    for (int deepest = 0; deepest < 4; ++deepest) {
        const auto colours = without_deeper_levels({}, drawing.pieces(), n, deepest, {1, 0, 0});
        REQUIRE(colours.size() == drawing.dots.size());
        std::size_t shown = 0;
        for (const glm::u8vec4 colour : colours) {
            CHECK(glm::u8vec3(colour) == glm::u8vec3(255, 0, 0));
            shown += colour.a == 255;
        }
        // On a grey this dark the first levels are complete: N dots, and four times as many with each more.
        CHECK(shown == n << (2 * deepest));
        CHECK(shown > before);
        before = shown;
    }
    CHECK(without_deeper_levels({}, drawing.pieces(), n, kDeepestStep, {}).empty());
}

TEST_CASE("the eight orientations have eight colours") {
    std::set<std::tuple<float, float, float>> colours;
    for (const Orientation g : all_orientations()) {
        const glm::vec3 c = orientation_colour(g);
        colours.insert({c.r, c.g, c.b});
    }
    CHECK(colours.size() == 8);
}

TEST_CASE("the dots of the page are coloured as chosen, and the same dots as in ink") {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(32, 32, 0.25f)});
    DotsRequest request;
    request.drawing.tile = "aperiodic64";
    request.drawing.placing.count = 3000;
    request.drawing.relax = 0;
    request.in_part = false;
    PlacedDrawing ink, coloured;
    REQUIRE(bench.place(request, ink));
    CHECK(ink.colours.empty());
    const Dots dots = joined(ink.dots);
    CHECK(dots.threshold.empty());
    for (const DotColourChoice& choice :
         {DotColourChoice{.colouring = DotColouring::level},
          DotColourChoice{.colouring = DotColouring::orientation}, DotColourChoice{.deepest_level = 1}}) {
        request.colours = choice;
        REQUIRE(bench.place(request, coloured));
        CHECK(joined(coloured.dots).x == dots.x);
        REQUIRE(coloured.colours.size() == 3000);
        const auto different = std::ranges::count_if(
            coloured.colours, [&](glm::u8vec4 colour) { return colour != coloured.colours[0]; });
        CHECK(different > 100);
    }
}

}  // namespace dapple
