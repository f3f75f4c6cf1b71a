#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>
#include <random>
#include <set>
#include <utility>

#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/tile/ranking.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

struct Expected {
    double x, y, margin;  // margin: scale * density / threshold - 1
};

// Every newborn point of every tile of every level, tested one by one: no pyramid, no early end. Wherever
// tiles begin, four root tiles have all of the page.
void test_every_point(const Density& density, double scale, const Tile& tile, const Ranking& ranking,
                      int levels, std::vector<Expected>& found) {
    struct Placed {
        glm::dvec2 corner;
        Orientation orientation;
        std::size_t kind;
    };
    const auto consider = [&](glm::dvec2 p, double threshold) {
        const double margin = scale * density.at(p) / threshold - 1;
        if (margin > -1e-4) found.push_back({p.x, p.y, margin});
    };
    const auto newborns = newborns_of(tile);
    std::vector<Placed> tiles;
    for (const glm::dvec2 whole : {glm::dvec2(-1, -1), {0, -1}, {-1, 0}, {0, 0}}) {
        const glm::dvec2 corner = density.tile_corner() + whole;
        for (std::size_t i = 0; i < tile.size(); ++i)
            consider(corner + to_unit_square(tile.points[i]), ranking.tile[i] / 16);
        tiles.push_back({corner, {}, 0});
    }
    for (int level = 0; level < levels; ++level) {
        const double side = std::ldexp(1.0, -level);
        std::vector<Placed> next;
        for (const Placed& placed : tiles) {
            const std::size_t count = 3 * tile.size(), first = placed.kind * count;
            for (std::size_t i = first; i < first + count; ++i) {
                const glm::dvec2 p =
                    apply(placed.orientation, to_unit_square(newborns[i].position) - 0.5) + 0.5;
                consider(placed.corner + side * p, std::ldexp(ranking.newborn[i] / 16.0, 2 * level));
            }
            for (int q = 0; q < 4; ++q) {
                const int at = apply_to_quadrant(placed.orientation, q);
                next.push_back({placed.corner + side / 2 * glm::dvec2(at & 1, at >> 1),
                                compose(placed.orientation, tile.rule.child[q]),
                                tile.next_kind[placed.kind][q]});
            }
        }
        tiles = std::move(next);
    }
}

// The placed dots are the expected ones, but for those so near their threshold that rounding decides.
void check_same(const Dots& dots, std::vector<Expected> expected) {
    std::vector<std::pair<double, double>> placed;
    for (std::size_t i = 0; i < dots.size(); ++i) placed.emplace_back(dots.x[i], dots.y[i]);
    std::sort(placed.begin(), placed.end());
    std::size_t matched = 0;
    for (const Expected& e : expected) {
        auto at = std::lower_bound(placed.begin(), placed.end(), std::pair{e.x - 2e-7, -1.0});
        bool here = false;
        for (; at != placed.end() && at->first <= e.x + 2e-7; ++at)
            here = here || std::abs(at->second - e.y) < 2e-7;
        if (!here && e.margin > 1e-4) FAIL("no dot at ", e.x, ",", e.y, " margin ", e.margin);
        matched += here;
    }
    CHECK(matched == placed.size());
}

Dots placed(const PlacingTable& table, const Density& density, const PlacingRequest& request) {
    Placer placer(std::shared_ptr<const PlacingTable>(std::shared_ptr<void>(), &table));  // without owning it
    DotPieces dots;
    CHECK(placer.place(density, request, dots));
    return joined(dots);
}

}  // namespace

TEST_CASE("the placer's dots are those that testing every point of every level finds") {
    for (const auto& [rule, size] :
         {std::pair{Rule{}, 16}, {kTurning, 16}, {kTurning, 20}, {kTurning, 64}, {kTurning, 300}}) {
        const Tile tile = random_tile(rule, size, 5 + size);
        const Ranking ranking = rank(tile, size > 100 ? RankingMethod::paper : RankingMethod::energy);
        const PlacingTable table = make_placing_table(tile, ranking);
        for (const auto& [width, height] : {std::pair{24, 24}, {31, 7}, {1, 1}, {3, 40}}) {
            const Grid<float> values = blotches(width, height, size + width);
            for (const Density& density :
                 {Density(values), page_density(values), page_density(values, Reading::by_cell)}) {
                const double scale = 350;
                std::vector<Expected> expected;
                test_every_point(density, scale, tile, ranking, size > 100 ? 3 : size > 20 ? 4 : 5, expected);
                const Dots dots = placed(table, density, {scale});
                CHECK(dots.size() > 20);
                check_same(dots, expected);
            }
        }
    }
}

TEST_CASE("so they are of tiles of several kinds, turned or not") {
    for (const auto& [rule, size] : {std::pair{Rule{}, 16u}, {kTurning, 64u}, {Rule{}, 300u}}) {
        const Tile tile = random_kinds(rule, kThreeKinds, size, size);
        const Ranking ranking = rank(tile, RankingMethod::energy);
        const PlacingTable table = make_placing_table(tile, ranking);
        for (const Reading reading : {Reading::bilinear, Reading::by_cell}) {
            const Density density = page_density(blotches(31, 17, size), reading);
            std::vector<Expected> expected;
            test_every_point(density, 350, tile, ranking, size > 100 ? 3 : size > 20 ? 4 : 5, expected);
            const Dots dots = placed(table, density, {350});
            CHECK(dots.size() > 20);
            check_same(dots, expected);
        }
    }
}

TEST_CASE("white paper gets no dots") {
    const PlacingTable table = make_placing_table(make_tile(14217, 2895, 16),
                                                  rank(make_tile(14217, 2895, 16), RankingMethod::energy));
    CHECK(placed(table, Density(Grid<float>(20, 20)), {1e6}).size() == 0);
}

TEST_CASE("the number of dots is 16 * scale * mean density, and grows one dot at a time") {
    const Tile tile = make_tile(14217, 2895, 16);
    const PlacingTable table = make_placing_table(tile, rank(tile, RankingMethod::energy));
    const Density grey(Grid<float>(8, 8, 1.0f));
    for (const double scale : {0.5, 1.0, 3.0, 100.0, 1000.0, 2500.0}) {
        const double expected = 16 * scale;
        CHECK(std::abs(static_cast<double>(placed(table, grey, {scale}).size()) - expected) <=
              1 + expected * 0.011);
    }
    CHECK(placed(table, grey, {1024.001}).size() == 16384);
}

TEST_CASE(
    "dots are the same, in the same order, on any number of threads, with their thresholds or without") {
    const Tile tile = random_tile(kTurning, 64, 11);
    const PlacingTable table = make_placing_table(tile, rank(tile, RankingMethod::energy));
    const Density density = page_density(blotches(90, 60, 3));
    const Dots one = placed(table, density, {.scale = 20000, .thresholds = true});
    CHECK(one.size() > 30000);
    CHECK(one.threshold.size() == one.size());
    CHECK(one.critical.size() == one.size());
    for (const bool thresholds : {true, false}) {
        for (const int threads : {1, 2, 3, 0}) {
            const Dots many =
                placed(table, density, {.scale = 20000, .threads = threads, .thresholds = thresholds});
            CHECK(many.x == one.x);
            CHECK(many.y == one.y);
            CHECK(many.threshold == (thresholds ? one.threshold : FloatBuffer{}));
            CHECK(many.critical == (thresholds ? one.critical : FloatBuffer{}));
        }
    }
}

TEST_CASE("a dot exists at scales above its critical scale and not below") {
    const Tile tile = random_tile(kTurning, 16, 2);
    const PlacingTable table = make_placing_table(tile, rank(tile, RankingMethod::energy));
    const Density density = page_density(blotches(16, 16, 9));
    const Dots dense = placed(table, density, {.scale = 3000, .thresholds = true});
    for (const double scale : {17.0, 400.0, 1234.5}) {
        std::multiset<std::pair<float, float>> expected;
        for (std::size_t i = 0; i < dense.size(); ++i) {
            if (dense.critical[i] < scale) expected.emplace(dense.x[i], dense.y[i]);
        }
        const Dots dots = placed(table, density, {scale});
        CHECK(dots.size() == expected.size());
        for (std::size_t i = 0; i < dots.size(); ++i) {
            if (!expected.contains({dots.x[i], dots.y[i]})) FAIL("dot ", i, " at scale ", scale);
        }
    }
}

TEST_CASE(
    "on black, each dot comes just above the scale that its rank and level say, wherever its square lies") {
    for (const int size : {16, 300}) {
        const Tile tile = random_tile(kTurning, size, 6);
        const Ranking ranking = rank(tile, size > 100 ? RankingMethod::paper : RankingMethod::energy);
        const PlacingTable table = make_placing_table(tile, ranking);
        // All dots' thresholds up to a few thousand, one for each tile of a level.
        std::vector<std::pair<float, std::size_t>> thresholds;
        for (const float rank : ranking.tile) thresholds.emplace_back(rank / 16, 1);
        for (int level = 0; level < (size > 100 ? 4 : 6); ++level)
            for (const float rank : ranking.newborn)
                thresholds.emplace_back(std::ldexp(rank / 16, 2 * level), std::size_t{1} << 2 * level);
        std::sort(thresholds.begin(), thresholds.end());
        // A map that wraps round has a way of its own about its seam.
        // Wherever tiles begin, a square page has as many of each.
        for (const Density& black :
             {Density(Grid<float>(8, 8, 1.0f)), Density(Grid<float>(8, 8, 1.0f), Sides::wrap),
              page_density(Grid<float>(8, 8, 1.0f))}) {
            std::size_t below = 0;
            for (std::size_t i = 0; i < thresholds.size();) {
                const float threshold = thresholds[i].first;
                std::size_t here = 0;
                for (; i < thresholds.size() && thresholds[i].first == threshold; ++i)
                    here += thresholds[i].second;
                // All of one level, and of the others those next to the ends of a level.
                if (size == 16 || below < 4000 || i % 97 == 0) {
                    CAPTURE(size);
                    CAPTURE(threshold);
                    CHECK(placed(table, black, {threshold}).size() == below);
                    // As near above as the kernels' single precision tells apart from it.
                    const float above = std::nextafter(std::nextafter(threshold, 1e9f), 1e9f);
                    CHECK(placed(table, black, {above}).size() == below + here);
                }
                below += here;
            }
        }
    }
}

TEST_CASE("a dot on the edge that two windows share is in the right or lower one alone") {
    const Tile tile = random_tile(kTurning, 16, 3);
    const PlacingTable table = make_placing_table(tile, rank(tile, RankingMethod::energy));
    const CellPoints& points = table.cells[0].all;  // on the page from -1 to 1, when only they are drawn
    for (const Density& black :
         {Density(Grid<float>(16, 16, 1.0f)), Density(Grid<float>(16, 16, 1.0f), Sides::wrap),
          page_density(Grid<float>(16, 16, 1.0f))}) {
        const auto count = [&](const PageWindow& window) {
            return placed(table, black, {.scale = 1, .window = window}).size();
        };
        REQUIRE(count({}) == 16);  // the tile's own
        // Beyond the page's edge the next root tile goes on.
        const auto on_page = [&](std::size_t i) {
            const glm::dvec2 p = (1.0 + glm::dvec2(points[i].x, points[i].y)) / 2.0 + black.tile_corner();
            return p - glm::floor(p);
        };
        for (std::size_t i = 0; i < 16; ++i) {
            CAPTURE(i);
            const auto [x, y] = std::pair(on_page(i).x, on_page(i).y);
            const auto units = [](double at) { return static_cast<std::int64_t>(std::ldexp(at, 62)); };
            std::size_t left = 0, above = 0;
            for (std::size_t k = 0; k < 16; ++k) {
                left += on_page(k).x < x;
                above += on_page(k).y < y;
            }
            CHECK(count({.width = x}) == left);
            CHECK(count({.x = units(x), .width = 1 - x}) == 16 - left);
            CHECK(count({.height = y}) == above);
            CHECK(count({.y = units(y), .height = 1 - y}) == 16 - above);
            // An edge that is by 2^-42 further on has passed it, which single precision cannot tell.
            const std::int64_t past = 1 << 20;
            CHECK(count({.width = x + 0x1p-42}) == left + 1);
            CHECK(count({.x = units(x) + past, .width = 1 - x}) == 15 - left);
            CHECK(count({.height = y + 0x1p-42}) == above + 1);
            CHECK(count({.y = units(y) + past, .height = 1 - y}) == 15 - above);
        }
    }
}

TEST_CASE("windows that tile the page share its dots out without a lost or doubled one") {
    const Tile tile = random_tile(kTurning, 64, 4);
    const PlacingTable table = make_placing_table(tile, rank(tile, RankingMethod::energy));
    const Density density = page_density(blotches(50, 40, 1));
    const double scale = 2000;
    const Dots whole = placed(table, density, {scale});
    std::multiset<std::pair<long, long>> expected, found;
    const auto key = [](double x, double y) { return std::pair{std::lround(x * 1e6), std::lround(y * 1e6)}; };
    for (std::size_t i = 0; i < whole.size(); ++i) expected.insert(key(whole.x[i], whole.y[i]));
    const std::int64_t third = (std::int64_t{1} << 62) / 3;
    std::size_t total = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            PageWindow window{column * third, row * third, static_cast<double>(third) * 0x1p-62,
                              static_cast<double>(third) * 0x1p-62};
            const Dots part = placed(table, density, {.scale = scale, .window = window});
            total += part.size();
            for (std::size_t i = 0; i < part.size(); ++i) {
                CHECK(part.x[i] >= 0);
                CHECK(part.x[i] <= 1.0f / 3);
                found.insert(key(part.x[i] + column / 3.0, part.y[i] + row / 3.0));
            }
        }
    }
    CHECK(total == whole.size());
    std::size_t same = 0;
    for (const auto& [x, y] : found) {
        // Rounding may put a dot on the next millionth.
        bool here = false;
        for (long dx = -1; dx <= 1; ++dx) {
            for (long dy = -1; dy <= 1; ++dy) here = here || expected.contains({x + dx, y + dy});
        }
        same += here;
    }
    CHECK(same == total);
}

TEST_CASE("a column of dots keeps its numbers while it grows into large memory and back") {
    FloatBuffer column{1, 2, 3};
    column.reserve(kLargeMemory / sizeof(float) + 1);
    column.resize(column.capacity());
    column.back() = 4;
    CHECK(column[2] == 3);
    column.resize(2);
    column.shrink_to_fit();
    CHECK(column == FloatBuffer{1, 2});
}

TEST_CASE("level and rank can be read off thresholds") {
    for (const std::size_t n : {16u, 64u, 4096u}) {
        CHECK(tile_rank_of(0.5f / 16, n).level == 0);
        CHECK(tile_rank_of(static_cast<float>(double(n) - 0.5) / 16, n).rank == static_cast<int>(n) - 1);
        for (int level = 1; level < 20; ++level) {
            for (const double rank : {double(n), 2 * double(n), 4 * double(n) - 1}) {
                const TileRank born =
                    tile_rank_of(static_cast<float>(std::ldexp((rank + 0.5) / 16, 2 * level - 2)), n);
                CHECK(born.level == level);
                CHECK(born.rank == static_cast<int>(rank));
            }
        }
    }
}
