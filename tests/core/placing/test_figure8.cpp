#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/placing/stipple.h"
#include "core/tile/ranking.h"
#include "tests/densities.h"

using namespace dapple;

namespace {

std::set<std::pair<float, float>> distinct(const Dots& dots) {
    std::set<std::pair<float, float>> places;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        // An inherited dot is computed along another path: equal but for the last bits.
        places.emplace(std::round(dots.x[i] * 0x1p20f), std::round(dots.y[i] * 0x1p20f));
    }
    return places;
}

}  // namespace

TEST_CASE("Figure 8 emits 54,608 dots for a constant density at scale 2500, of which 40,960 are distinct") {
    const Tile tile = make_tile(14217, 2895, 16);
    const Figure8Result result =
        place_figure8(Density(Grid<float>(4, 4, 1.0f)), tile, farthest_point_ranks(tile), 2500);
    CHECK(result.dots.size() == 54608);
    CHECK(distinct(result.dots).size() == 40960);
    CHECK(result.duplicates == 54608 - 40960);
}

TEST_CASE("a dot of Figure 8's says its level, and its rank in the tile that emitted it") {
    const Tile tile = make_tile(14217, 2895, 16);
    const std::vector<int> ranks = farthest_point_ranks(tile);
    const Dots dots = place_figure8(Density(Grid<float>(4, 4, 1.0f)), tile, ranks, 2500).dots;
    // The root, and its first child, and so on down: each tile has all of its points.
    for (std::size_t i = 0; i < 4 * 16; ++i) {
        const TileRank at = figure8_rank_of(dots.threshold[i], 16);
        CHECK(at.level == static_cast<int>(i / 16));
        CHECK(at.rank == ranks[i % 16]);
    }
}

TEST_CASE("Figure 8 draws a dot, and divides a tile, above its threshold and not at it") {
    const Tile tile = make_tile(14217, 2895, 16);
    const std::vector<int> ranks = farthest_point_ranks(tile);
    const Density black(Grid<float>(4, 4, 1.0f));
    const auto place = [&](double scale) { return place_figure8(black, tile, ranks, scale); };
    const auto next = [](double scale) { return std::nextafter(scale, 1e9); };
    // The root tile's thresholds go from a quarter to 1 in sixteen steps, each taken in its middle.
    for (int rank = 0; rank < 16; ++rank) {
        CAPTURE(rank);
        const double threshold = 0.25 + (rank + 0.5) * 0.75 / 16;
        CHECK(place(threshold).dots.size() == static_cast<std::size_t>(rank));
        CHECK(place(next(threshold)).dots.size() == static_cast<std::size_t>(rank) + 1);
    }
    // A tile of level l has all of its dots at scale 4^l, and its children only beyond.
    for (const auto& [scale, tiles] : {std::pair{1.0, 1u}, {4.0, 5u}, {16.0, 21u}}) {
        CAPTURE(scale);
        CHECK(place(scale).tiles.size() == tiles);
        CHECK(place(next(scale)).tiles.size() == 4 * tiles + 1);
    }
}

TEST_CASE("a hairline that Figure 8 loses is drawn by the exact placer") {
    // One pixel of 512, and four of them (0.8 % of the picture's width).
    for (const int width : {1, 4}) {
        Grid<float> grid(512, 512);
        for (int x = 100; x < 100 + width; ++x) {
            for (int y = 0; y < 512; ++y) grid.at(x, y) = 1;
        }
        const Density density(grid);
        RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
        CHECK(place_figure8(density, tile.tile(), tile.own_ranks(), 2500).dots.size() == 0);
        DotPieces dots;
        CHECK(tile.placer().place(density, {2500}, dots));
        const double expected = 16 * 2500 * density.mean();
        // A line thinner than the dots' spacing meets more of them, or fewer, as it happens to lie.
        CHECK(static_cast<double>(dots.size()) > expected / 2);
        CHECK(static_cast<double>(dots.size()) < expected * 2);
    }
}

TEST_CASE("Figure 8 refuses tiles that the paper does not know") {
    const Rule rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
    const Tile tile = make_tile(rule, {"0301213303211022"});
    CHECK_THROWS(place_figure8(Density(Grid<float>(4, 4, 1.0f)), tile, farthest_point_ranks(tile), 10));
}

TEST_CASE("a count asked of Figure 8 is met by as many distinct dots, or a hundredth more") {
    RankedTile paper(make_tile(14217, 2895, 16), RankingMethod::paper);
    const Density density(blotches(60, 45, 2));
    for (const std::uint64_t count : {1, 300, 20'000}) {
        CAPTURE(count);
        Stippling result;
        REQUIRE(stipple(paper, density, PlacerKind::figure8, {.count = count}, result));
        const auto places = distinct(result.dots.pieces[0]);
        CHECK(places.size() == result.dots.size() - result.duplicates);
        CHECK(places.size() >= count);
        CHECK(static_cast<double>(places.size()) <= 1.01 * static_cast<double>(count) + 1);
        Stippling again;  // the scale told is the one it was placed at
        REQUIRE(stipple(paper, density, PlacerKind::figure8, {.scale = result.scale}, again));
        CHECK(again.dots.size() == result.dots.size());
    }
}

TEST_CASE("Figure 8 stops when it is asked to, by count and by scale") {
    RankedTile paper(make_tile(14217, 2895, 16), RankingMethod::paper);
    const Density density(Grid<float>(4, 4, 1.0f));
    std::stop_source stop;
    stop.request_stop();
    Stippling result;
    CHECK_FALSE(stipple(paper, density, PlacerKind::figure8, {.count = 2000}, result, stop.get_token()));
    CHECK_FALSE(stipple(paper, density, PlacerKind::figure8, {.scale = 2500}, result, stop.get_token()));
    CHECK(place_figure8(density, paper.tile(), paper.own_ranks(), 2500, stop.get_token()).dots.size() == 0);
}

TEST_CASE("Figure 8 says so where it does not find as many dots as asked for") {
    RankedTile paper(make_tile(14217, 2895, 16), RankingMethod::paper);
    Stippling result;
    CHECK_THROWS_WITH(stipple(paper, Density(Grid<float>(4, 4)), PlacerKind::figure8, {.count = 10}, result),
                      "the paper's placer (figure8) does not find 10 places in this picture's dark parts; "
                      "use the exact placer");
    // It loses the spot until the scale is that of the dim rest, and by then the spot has a thousand million.
    Grid<float> spot(64, 64, 1e-9f);
    spot.at(37, 21) = 1;
    CHECK_THROWS_WITH(stipple(paper, Density(spot), PlacerKind::figure8, {.count = 1000}, result),
                      doctest::Contains("does not find 1000 places"));
}
