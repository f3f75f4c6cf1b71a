// The disorder that dots are given before they are relaxed.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

Stippling placed(const Density& density, std::uint64_t count) {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    Stippling result;
    REQUIRE(stipple(tile, density, PlacerKind::exact, {.count = count}, result));
    return result;
}

Dots stirred(const Stippling& from, const Density& density, int threads = 1) {
    DotPieces dots = from.dots;
    stir(dots, density, {.scale = from.scale, .threads = threads});
    return joined(dots);
}

glm::dvec2 place(const Dots& dots, std::size_t i) {
    return {dots.x[i], dots.y[i]};
}

}  // namespace

TEST_CASE("dots are carried a fifth of their distance each way, whatever the distance, and no way more") {
    for (const double dots : {40'000.0, 61'000.0}) {
        for (const double apart : {1 / std::sqrt(dots), 3 / std::sqrt(dots)}) {
            glm::dvec2 mean(0), square(0);
            double product = 0;
            constexpr int kSide = 300;
            for (int i = 0; i < kSide * kSide; ++i) {
                const glm::vec2 at((static_cast<float>(i % kSide) + 0.3f) / kSide,
                                   (static_cast<float>(i / kSide) + 0.6f) / kSide);
                const glm::dvec2 move = glm::dvec2(stirring_at(at, static_cast<float>(apart))) / apart;
                mean += move / double(kSide * kSide);
                square += move * move / double(kSide * kSide);
                product += move.x * move.y / (kSide * kSide);
            }
            CHECK(glm::length(mean) < 0.02);
            CHECK(std::sqrt(square.x) == doctest::Approx(0.2).epsilon(0.05));
            CHECK(std::sqrt(square.y) == doctest::Approx(0.2).epsilon(0.05));
            CHECK(std::abs(product) < 0.003);
        }
    }
}

TEST_CASE("what flows into a small square flows out of it, and the flow is another a little away") {
    constexpr double kDots = 50'000;
    const auto apart = static_cast<float>(1 / std::sqrt(kDots));
    const float half = apart / 50;
    double out = 0, along = 0, near = 0, far = 0, square = 0;
    for (int i = 0; i < 10'000; ++i) {
        const glm::vec2 at(0.1f + 0.007f * static_cast<float>(i % 100),
                           0.1f + 0.007f * static_cast<float>(i / 100));
        const auto flow = [&](float x, float y) { return stirring_at(at + glm::vec2(x, y), apart); };
        const glm::vec2 here = flow(0, 0);
        const double across = flow(half, 0).x - flow(-half, 0).x, down = flow(0, half).y - flow(0, -half).y;
        out += (across + down) * (across + down);
        along += across * across + down * down;
        square += glm::dot(here, here);
        near += glm::dot(here, flow(apart / 4, 0));
        far += glm::dot(here, flow(8 * apart, 0));
    }
    CHECK(out < 0.02 * along);
    CHECK(near > 0.8 * square);
    CHECK(std::abs(far) < 0.05 * square);
}

TEST_CASE("a dot is carried alike whatever others are there, and by any number of threads") {
    const Density density(blotches(40, 30, 3));
    const Stippling before = placed(density, 3000);
    const Dots from = joined(before.dots), all = stirred(before, density);
    const Dots on_three = stirred({.dots = split(from), .scale = before.scale}, density, 3);
    CHECK(on_three.x == all.x);
    CHECK(on_three.y == all.y);
    Dots some, wanted;
    for (std::size_t i = 0; i < from.size(); i += 7) {
        some.x.push_back(from.x[i]);
        some.y.push_back(from.y[i]);
        wanted.x.push_back(all.x[i]);
        wanted.y.push_back(all.y[i]);
    }
    const Dots alone = stirred({.dots = in_one_piece(some), .scale = before.scale}, density);
    CHECK(alone.x == wanted.x);
    CHECK(alone.y == wanted.y);
}

TEST_CASE("no dot is carried off the page, off a line, out of its ink, or farther than is said") {
    Grid<float> line(50, 50, 0.0f);
    for (int y = 0; y < 50; ++y) line.at(17, y) = 1;
    for (const Grid<float>& grid : {line, blotches(60, 40, 5), Grid<float>(9, 5, 0.002f)}) {
        const Density density(grid);
        for (const std::uint64_t count : {3u, 40u, 2000u}) {
            const Stippling before = placed(density, count);
            const Dots from = joined(before.dots), to = stirred(before, density);
            REQUIRE(to.size() == from.size());
            double least_share = 1, farthest = 0;
            for (std::size_t i = 0; i < to.size(); ++i) {
                least_share = std::min(least_share, density.at(place(to, i)) / density.at(place(from, i)));
                farthest = std::max(farthest, glm::distance(place(to, i), place(from, i)));
            }
            CHECK(least_share > 0.24);  // off the page there is none
            CHECK(farthest <= 1.001 * farthest_stirred(before.scale));
        }
    }
}

TEST_CASE("a lattice, which steps alone leave as it is, is one no more once relaxed") {
    const Density density(Grid<float>(1, 1, 1.0f));
    constexpr int kSide = 60;
    Dots lattice;
    for (int i = 0; i < kSide * kSide; ++i) {
        lattice.x.push_back((static_cast<float>(i % kSide) + 0.5f) / kSide);
        lattice.y.push_back((static_cast<float>(i / kSide) + 0.5f) / kSide);
    }
    const auto stayed = [](const Dots& dots) {
        int count = 0;
        for (const float x : dots.x) count += std::abs(x * kSide - std::floor(x * kSide) - 0.5f) < 0.05f;
        return count / double(dots.size());
    };
    const double scale = kSide * kSide / kDotsPerScale;
    Relaxation steps(in_one_piece(lattice), density, {.scale = scale});
    for (int i = 0; i < 3; ++i) steps.step();
    DotPieces dots = in_one_piece(lattice);
    REQUIRE(relax(dots, density, 3, {.scale = scale}));
    CHECK(stayed(joined(steps.dots())) > 0.5);
    CHECK(stayed(joined(dots)) < 0.25);
}

TEST_CASE("dots of a few tiles are stirred a little, and those of one that is to repeat not at all") {
    PlacingTable table;
    table.tile_size = 1000;
    table.next_kind = NextKinds(2);
    const auto of_tiles = [&](double tiles) { return stirring_of(table, tiles * 1000 / kDotsPerScale); };
    CHECK(of_tiles(1.9) == 0);
    CHECK(of_tiles(9) == doctest::Approx(0.5));
    CHECK(of_tiles(17) == 1);
    table.next_kind = NextKinds(1);
    CHECK(of_tiles(17) == 0);
    table.rule.child[2] = Orientation{5};
    CHECK(of_tiles(17) == 1);
}

TEST_CASE("dots that are to be stirred half are carried half the way") {
    const Density density(Grid<float>(1, 1, 1.0f));
    const Stippling before = placed(density, 1600);
    const Dots from = joined(before.dots), wholly = stirred(before, density);
    DotPieces dots = before.dots;
    stir(dots, density, {.scale = before.scale, .stirring = 0.5});
    const Dots half = joined(dots);
    int inside = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
        const glm::dvec2 at = place(from, i), whole = place(wholly, i) - at;
        if (at.x + whole.x < 0.01 || at.x + whole.x > 0.99 || at.y + whole.y < 0.01 || at.y + whole.y > 0.99)
            continue;
        CHECK(glm::distance(place(half, i), at + whole / 2.0) < 1e-6);
        ++inside;
    }
    CHECK(inside > 1400);
}
