#include <doctest/doctest.h>

#include <algorithm>
#include <compare>
#include <set>
#include <utility>
#include <vector>

#include "core/placing/dot_order.h"
#include "core/placing/placer.h"
#include "core/tile/ranking.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

struct Dot {
    float x, y, threshold, critical;
    auto operator<=>(const Dot&) const = default;
};

std::vector<Dot> rows(const Dots& dots) {
    std::vector<Dot> rows(dots.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = {dots.x[i], dots.y[i], dots.threshold[i], dots.critical[i]};
    return rows;
}

Placer placer_of(const Tile& tile) {
    return Placer(make_placing_table(tile, rank(tile, RankingMethod::energy)));
}

}  // namespace

TEST_CASE("an exact count is exact, and each lighter drawing is part of the darker one") {
    const Tile tile = make_tile(14217, 2895, 16);
    Placer placer(make_placing_table(tile, rank(tile, RankingMethod::energy)));
    const Density density(blotches(40, 30, 8));
    std::set<std::pair<float, float>> darker;
    for (const std::uint64_t count : {20000u, 19999u, 5000u, 777u, 10u, 1u}) {
        DotPieces placed;
        const auto scale = placer.place(density, {.count = count, .thresholds = true}, placed);
        REQUIRE(scale);
        const Dots dots = joined(placed);
        CHECK(dots.size() == count);
        CHECK(*std::max_element(dots.critical.begin(), dots.critical.end()) <= *scale);
        std::set<std::pair<float, float>> lighter;
        for (std::size_t i = 0; i < dots.size(); ++i) lighter.emplace(dots.x[i], dots.y[i]);
        CHECK(lighter.size() == count);
        if (!darker.empty())
            CHECK(std::includes(darker.begin(), darker.end(), lighter.begin(), lighter.end()));
        darker = lighter;
    }
    DotPieces none;
    CHECK_THROWS(placer.place(Density(Grid<float>(4, 4)), {.count = 100}, none));
}

TEST_CASE("an exact count keeps the dots of lowest critical scale, the same on any number of threads") {
    Placer placer = placer_of(random_tile(kTurning, 64, 8));
    const Density density(blotches(60, 45, 2));
    DotPieces all;
    placer.place(density, {.scale = 60000, .thresholds = true}, all);
    const std::vector<Dot> every = rows(joined(all));
    for (const std::size_t count : {1u, 50u, 3000u, 40000u}) {
        std::vector<float> scales;
        for (const Dot& dot : every) scales.push_back(dot.critical);
        std::ranges::nth_element(scales, scales.begin() + static_cast<std::ptrdiff_t>(count));
        const float first_dropped = scales[count];
        std::vector<Dot> on_one_thread;
        for (const int threads : {1, 2, 0}) {
            DotPieces dots;
            const auto scale =
                placer.place(density, {.count = count, .threads = threads, .thresholds = true}, dots);
            REQUIRE(scale);
            std::vector<Dot> kept = rows(joined(dots));
            REQUIRE(kept.size() == count);
            if (threads == 1) on_one_thread = kept;
            CHECK(kept == on_one_thread);
            // Those surely below stay, the rest are some of those that tie with the first that is dropped.
            std::ranges::sort(kept);
            std::size_t found = 0;
            for (const Dot& dot : every) {
                const bool here = std::ranges::binary_search(kept, dot);
                if (dot.critical < first_dropped) CHECK(here);
                if (dot.critical > first_dropped) CHECK_FALSE(here);
                found += here;
            }
            CHECK(found == kept.size());
            CHECK(*scale >= std::ranges::max_element(kept, {}, &Dot::critical)->critical);
        }
    }
}

TEST_CASE("an exact count comes in pieces as it comes whole, on any number of threads") {
    Placer placer = placer_of(random_tile(kTurning, 64, 8));
    for (const Density& density : {Density(blotches(60, 45, 2)), Density(Grid<float>(9, 9, 1.0f))}) {
        for (const std::size_t count : {0u, 1u, 777u, 50000u}) {
            DotPieces whole;
            const auto scale = placer.place(density, {.count = count, .thresholds = true}, whole);
            for (const int threads : {1, 3}) {
                PlacingRequest request{.count = count, .threads = threads, .thresholds = true};
                const auto cut = placer.find_cut(density, request);
                REQUIRE(cut);
                CHECK(cut->last_scale() == doctest::Approx(*scale));
                if (threads == 3) request.cut = cut;
                std::vector<Dot> together;
                const auto take = [&](const Dots& piece) {
                    for (const Dot& dot : rows(piece)) together.push_back(dot);
                    return true;
                };
                CHECK(placer.hand_over(density, request, take));
                CHECK(together == rows(joined(whole)));
            }
        }
    }
}

TEST_CASE("a window of an exact count has those of the whole page's dots that lie in it, at their places") {
    Placer placer = placer_of(random_tile(kTurning, 64, 8));
    const Density density(blotches(60, 45, 2));
    constexpr double kUnits = 0x1p62;
    const PageWindow window{static_cast<std::int64_t>(0.25 * kUnits),
                            static_cast<std::int64_t>(0.125 * kUnits), 0.5, 0.25};
    PlacingRequest request{.count = 20'000, .thresholds = true};
    DotPieces whole, part;
    REQUIRE(placer.place(density, request, whole));
    std::vector<Dot> expected;
    for (const Dot& dot : rows(joined(whole))) {
        if (dot.x >= 0.25f && dot.x < 0.75f && dot.y >= 0.125f && dot.y < 0.375f) expected.push_back(dot);
    }
    REQUIRE(expected.size() > 1000);
    request.window = window;
    for (const int threads : {1, 3}) {
        request.threads = threads;
        REQUIRE(placer.place(density, request, part));
        CHECK(rows(joined(part)) == expected);
    }
    request.cut = placer.find_cut(density, request);
    REQUIRE(placer.place(density, request, part));
    CHECK(rows(joined(part)) == expected);
}

TEST_CASE("where all dots tie, those that stay are spread over the whole page") {
    // On black, whole levels of dots have critical scales alike: a few more than one level's.
    Placer placer = placer_of(make_tile(14217, 2895, 16));
    const Density black(Grid<float>(4, 4, 1.0f));
    DotPieces level, more;
    placer.place(black, {.count = 16384}, level);
    placer.place(black, {.count = 16384 + 400}, more);
    std::set<std::pair<float, float>> before;
    for_each_position(level, [&](float x, float y) { before.emplace(x, y); });
    int quarters[4] = {};
    for_each_position(more, [&](float x, float y) {
        if (!before.contains({x, y})) ++quarters[(x > 0.5f) + 2 * (y > 0.5f)];
    });
    for (const int quarter : quarters) CHECK(std::abs(quarter - 100) <= 1);
}

TEST_CASE("by priority, the first n dots are the drawing of n dots, ties and all") {
    const Density black(Grid<float>(4, 4, 1.0f)), grey(Grid<float>(30, 20, 0.5f)),
        picture(blotches(60, 45, 2));
    for (const Tile& tile : {make_tile(14217, 2895, 16), random_tile(kTurning, 64, 8)}) {
        Placer placer = placer_of(tile);
        for (const Density* density : {&black, &grey, &picture}) {
            DotPieces darkest;
            placer.place(*density, {.count = 30'000, .thresholds = true}, darkest);
            Dots sorted = joined(darkest);
            sort_dots(sorted, DotOrder::priority);
            const std::vector<Dot> by_priority = rows(sorted);
            for (const std::size_t count : {1u, 2u, 100u, 12'345u, 21'000u, 29'999u}) {
                DotPieces lighter;
                placer.place(*density, {.count = count, .thresholds = true}, lighter);
                std::vector<Dot> first(by_priority.begin(), by_priority.begin() + count),
                    found = rows(joined(lighter));
                std::ranges::sort(first);
                std::ranges::sort(found);
                CHECK(first == found);
            }
        }
    }
}
