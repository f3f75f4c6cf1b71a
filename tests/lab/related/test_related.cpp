// The methods that dapple is compared with, against what their papers print and against brute force.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/report.h"
#include "core/tile/random.h"
#include "lab/related/bent_square.h"
#include "lab/related/best_candidate.h"
#include "lab/related/dart_throwing.h"
#include "lab/related/floyd_steinberg.h"
#include "lab/related/growing_grid.h"
#include "lab/related/jittered.h"
#include "lab/related/lbg.h"
#include "lab/related/methods.h"
#include "lab/related/plain_lloyd.h"
#include "lab/related/plain_voronoi.h"
#include "lab/related/quasi_random.h"
#include "lab/related/wang_tiles.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

double torus_distance2(glm::dvec2 a, glm::dvec2 b) {
    const double x = std::abs(a.x - b.x), y = std::abs(a.y - b.y);
    return std::pow(std::min(x, 1 - x), 2) + std::pow(std::min(y, 1 - y), 2);
}

Density left_dark_right_light() {
    Grid<float> values(40, 20);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) values.at(x, y) = x < 20 ? 0.75f : 0.25f;
    return Density(std::move(values));
}

}  // namespace

TEST_CASE("Halton's first points are those worked out by hand") {
    const PlainDots dots = halton({.count = 6});
    const PlainDots by_hand{{0, 0},
                            {1.0 / 2, 1.0 / 3},
                            {1.0 / 4, 2.0 / 3},
                            {3.0 / 4, 1.0 / 9},
                            {1.0 / 8, 4.0 / 9},
                            {5.0 / 8, 7.0 / 9}};
    REQUIRE(dots.size() == by_hand.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        CHECK(dots[i].x == doctest::Approx(by_hand[i].x));
        CHECK(dots[i].y == doctest::Approx(by_hand[i].y));
    }
    CHECK(hammersley({.count = 4})[3] == glm::dvec2(0.75, 0.75));
}

TEST_CASE("Sobol's first points are those that are published") {
    // Bratley & Fox 1988, Algorithm 659, whose sequence goes by Gray code.
    const PlainDots published{{0, 0},         {0.5, 0.5},     {0.75, 0.25},   {0.25, 0.75},
                              {0.375, 0.375}, {0.875, 0.875}, {0.625, 0.125}, {0.125, 0.625}};
    CHECK(sobol({.count = 8}) == published);
}

TEST_CASE("the first 4^k points of Sobol have one point in each box of that area") {
    const PlainDots dots = sobol({.count = 256});
    for (int across = 1; across <= 256; across *= 2) {
        std::vector<int> held(256);
        for (const glm::dvec2 p : dots)
            ++held[std::size_t(int(p.x * across) + across * int(p.y * (256 / across)))];
        CHECK(std::ranges::count(held, 1) == 256);
    }
}

TEST_CASE("the rank-1 lattice is the best of all, by brute force") {
    for (const std::uint32_t n : {2u, 5u, 31u, 144u}) {
        const auto nearest2 = [n](std::uint32_t g) {
            double least = 1;
            for (std::uint32_t i = 1; i < n; ++i)
                least = std::min(least, torus_distance2({0, 0}, {double(i) / n, double(g * i % n) / n}));
            return least;
        };
        double best = 0;
        for (std::uint32_t g = 1; g < n; ++g) best = std::max(best, nearest2(g));
        CAPTURE(n);
        CHECK(nearest2(best_generator(n)) == doctest::Approx(best));
    }
}

TEST_CASE("Floyd-Steinberg on three by three pixels is as worked out by hand") {
    // 1/2 is no dot, and its error 1/2 makes 23/32 of the next, which is one; and so on. In exact fractions,
    // row after row: .5, .719, .377; .604, .341, .749; .440, .727, .324.
    const Grid<std::uint8_t> set = error_diffused(Grid<float>(3, 3, 0.5f));
    CHECK(set.values == std::vector<std::uint8_t>{0, 1, 0, 1, 0, 1, 0, 1, 0});
}

TEST_CASE("maximal darts are never nearer than the radius, and leave no free place") {
    const double radius = 0.05;
    const PlainDots dots = maximal_darts(radius, 7);
    for (std::size_t i = 0; i < dots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) REQUIRE(torus_distance2(dots[i], dots[j]) >= radius * radius);
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 400; ++x) {
            const glm::dvec2 place(x / 400.0, y / 400.0);
            const bool near = std::ranges::any_of(
                dots, [&](glm::dvec2 p) { return torus_distance2(p, place) < radius * radius; });
            REQUIRE(near);
        }
    }
    CHECK(double(dart_throwing({.count = 5000}).size()) == doctest::Approx(5000).epsilon(0.02));
}

TEST_CASE("Wang tiles with the same colour at an edge have the same points along it, and no two too near") {
    const WangTiles& tiles = wang_tiles();
    REQUIRE(tiles.size() == 16);
    // All pairs of neighbours: the right edge of one has the colour of the left edge of the other.
    const double spacing = 1 / std::sqrt(double(kWangPoints));
    const auto along = [&](const WangTile& tile, double from) {
        PlainDots points;
        for (const glm::dvec2 p : tile.first)
            if (p.x >= from && p.x < from + spacing) points.push_back(p);
        std::ranges::sort(points, {}, &glm::dvec2::y);
        return points;
    };
    const auto across = [&](const WangTile& tile, double from) {
        PlainDots points;
        for (const glm::dvec2 p : tile.first)
            if (p.y >= from && p.y < from + spacing) points.push_back(p);
        std::ranges::sort(points, {}, &glm::dvec2::x);
        return points;
    };
    for (unsigned a = 0; a < 16; ++a) {
        CHECK(tiles[a].first.size() == kWangPoints);
        CHECK(tiles[a].later.size() == 15 * kWangPoints);
        for (unsigned b = 0; b < 16; ++b) {
            if ((a >> 3 & 1) == (b >> 3 & 1)) CHECK(along(tiles[a], 0) == along(tiles[b], 0));
            // The same down the page: bit 0 is the top edge, bit 2 the bottom one, below which b may lie.
            if ((a & 1) == (b & 1)) CHECK(across(tiles[a], 0) == across(tiles[b], 0));
            if ((a >> 2 & 1) == (b & 1))
                for (const glm::dvec2 p : across(tiles[a], 1 - spacing))
                    for (const glm::dvec2 q : across(tiles[b], 0))
                        REQUIRE(std::hypot(q.x - p.x, q.y + 1 - p.y) > 0.5 * spacing);
            if ((a >> 1 & 1) != (b >> 3 & 1)) continue;
            for (const glm::dvec2 p : along(tiles[a], 1 - spacing))
                for (const glm::dvec2 q : along(tiles[b], 0))
                    REQUIRE(std::hypot(q.x + 1 - p.x, q.y - p.y) > 0.5 * spacing);
        }
        // Away from the edges each point is one of a child's as well, so that nothing misfits there.
        std::size_t misfits = 0;
        for (const glm::dvec2 p : tiles[a].first) {
            if (std::min({p.x, p.y, 1 - p.x, 1 - p.y}) < 2.5 * spacing) continue;
            double nearest = 1;
            for (unsigned child = 0; child < 16; ++child) {
                const glm::dvec2 place = 4.0 * p - glm::dvec2(child % 4, child / 4);
                if (std::min(place.x, place.y) < -0.1 || std::max(place.x, place.y) > 1.1) continue;
                for (const glm::dvec2 q : tiles[tiles[a].children[child]].first)
                    nearest = std::min(nearest, std::hypot(q.x - place.x, q.y - place.y) / 4);
            }
            misfits += nearest > 1e-6 * spacing;
        }
        CHECK(misfits == 0);
        // Children meet at edges of the same colour.
        for (unsigned y = 0; y < 4; ++y)
            for (unsigned x = 0; x < 3; ++x)
                CHECK((tiles[a].children[4 * y + x] >> 1 & 1) == (tiles[a].children[4 * y + x + 1] >> 3 & 1));
        for (unsigned y = 0; y < 3; ++y)
            for (unsigned x = 0; x < 4; ++x)
                CHECK((tiles[a].children[4 * y + x] >> 2 & 1) == (tiles[a].children[4 * (y + 1) + x] & 1));
    }
}

TEST_CASE("the growing grid finds the nearest point that brute force finds") {
    Random random(3);
    for (const Topology topology : {Topology::torus, Topology::window}) {
        GrowingGrid grid({1, 1, topology});
        CHECK(std::isinf(grid.nearest2({0.5, 0.5}, 1)));
        for (int i = 0; i < 300; ++i) {
            const glm::dvec2 place(random.unit(), random.unit());
            double nearest2 = 1e300;
            for (const glm::dvec2 p : grid.points()) {
                const glm::dvec2 way = p - place;
                nearest2 = std::min(nearest2, topology == Topology::torus ? torus_distance2(p, place)
                                                                          : way.x * way.x + way.y * way.y);
            }
            if (i > 0) REQUIRE(grid.nearest2(place, 9) == doctest::Approx(nearest2));
            grid.add(place);
        }
    }
}

TEST_CASE("a jittered grid has one dot in each cell, anywhere in it") {
    const PlainDots dots = jittered_grid({.count = 900});
    std::vector<int> held(900), in_quarter(4);
    for (const glm::dvec2 p : dots) {
        ++held[std::size_t(int(p.x * 30) + 30 * int(p.y * 30))];
        ++in_quarter[std::size_t(int(p.x * 60) % 2 + 2 * (int(p.y * 60) % 2))];
    }
    CHECK(std::ranges::count(held, 1) == 900);
    // 225 of each, give or take five standard deviations.
    for (const int count : in_quarter) CHECK(std::abs(count - 225) < 65);
    CHECK(jittered_grid({.count = 997}).size() == 997);
}

TEST_CASE("plain steps of Lloyd know no edges: dots moved across them move alike") {
    PlainDots dots = sobol({.count = 64}), moved;
    for (glm::dvec2& p : dots) p += glm::dvec2(0.001 * p.y, 0.002 * p.x);
    for (const glm::dvec2 p : dots) moved.push_back(on_unit_torus(p + glm::dvec2(0.3, 0.7)));
    for (int step = 0; step < 3; ++step) {
        plain_lloyd_step(dots);
        plain_lloyd_step(moved);
    }
    for (std::size_t i = 0; i < dots.size(); ++i)
        CHECK(torus_distance2(on_unit_torus(dots[i] + glm::dvec2(0.3, 0.7)), moved[i]) < 1e-16);
}

TEST_CASE("cells fill the page, whatever they weigh, and weigh what the density does") {
    const Density density = left_dark_right_light();
    double area = 0, weight = 0;
    for (const CellMoments& cell :
         weighted_cells(random_dots(density, 300, 5), density, LloydWeight::density)) {
        area += cell.area;
        weight += cell.weight;
    }
    CHECK(area == doctest::Approx(0.5));
    CHECK(weight == doctest::Approx(density.mean()).epsilon(0.01));
    double torus = 0;
    for (const CellMoments& cell : plain_cells(white_noise({.count = 200}))) torus += cell.area;
    CHECK(torus == doctest::Approx(1));
}

TEST_CASE("what LBG splits goes apart by the cell's own area, in the light as in the dark") {
    // All ink is in the left half of a page of area 1/2, which is the cell of one of two dots: a disc of its
    // area, 1/4, has radius sqrt(1/4 / pi), and the halves lie half of that to either side.
    Grid<float> values(40, 20);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) values.at(x, y) = x < 20 ? 0.25f : 0.0f;
    const Density density(std::move(values));
    Random random(1);
    const LbgStep step =
        lbg_step({{0.25, 0.25}, {0.75, 0.25}}, {.density = &density, .count = 3}, 0.6, random);
    REQUIRE(step.dots.size() == 2);
    CHECK(step.changed);
    CHECK(std::hypot(step.dots[0].x - step.dots[1].x, step.dots[0].y - step.dots[1].y) ==
          doctest::Approx(std::sqrt(0.25 / std::numbers::pi)).epsilon(0.01));
}

TEST_CASE("every method keeps the count that it promises, the page, the picture's density and its seed") {
    const Density density = left_dark_right_light();
    for (const RelatedMethod& method : related_methods()) {
        CAPTURE(method.name);
        const std::size_t count = method.name == "gaussian" ? 100 : 1000;  // a thousand steps of each
        const PlainDots constant = method.dots({.count = count});
        CHECK(double(constant.size()) == doctest::Approx(double(count)).epsilon(0.03));
        for (const glm::dvec2 p : constant) REQUIRE((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
        CHECK(method.dots({.count = count}) == constant);
        const PlainDots dots = method.dots({.density = &density, .count = count});
        CHECK(double(dots.size()) == doctest::Approx(double(count)).epsilon(0.03));
        std::size_t left = 0;
        for (const glm::dvec2 p : dots) {
            REQUIRE((p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 0.5));
            left += p.x < 0.5;
        }
        // Lloyd's dots tend to the root of the weight (Secord's known flaw), from the density on.
        CHECK(double(left) / double(dots.size()) ==
              doctest::Approx(0.75).epsilon(method.name == "lloyd" ? 0.2 : 0.06));
    }
}

TEST_CASE("methods that say so begin with the drawing of fewer dots") {
    for (const RelatedMethod& method : related_methods()) {
        if (!method.nested) continue;
        CAPTURE(method.name);
        const PlainDots many = method.dots({.count = 400}), few = method.dots({.count = 100});
        CHECK(std::equal(few.begin(), few.end(), many.begin()));
    }
}

TEST_CASE("best candidates keep farther apart than white noise, and Lloyd's dots farthest") {
    const auto mean = [](const PlainDots& dots) { return nearest_summary(dots, Domain{}).mean; };
    const double noise = mean(related_method("white-noise")->dots({.count = 2000}));
    const double best = mean(best_candidate({.count = 2000}));
    CHECK(noise == doctest::Approx(0.4653).epsilon(0.05));
    CHECK(best > 0.7);
    CHECK(mean(lloyd({.count = 2000})) > best);
}

}  // namespace dapple
