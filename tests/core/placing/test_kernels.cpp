#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/placing/kernel.h"

using namespace dapple;

namespace {

// All tests of this program place with those that the environment names.
const char* const kWanted = std::getenv("DAPPLE_KERNELS");
const bool kChosen = [] {
    try {
        if (kWanted) choose_kernels(kWanted);
        return true;
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "DAPPLE_KERNELS: %s\n", error.what());
        std::exit(1);
    }
}();

struct Placed {
    std::vector<float> x, y, threshold, critical;
    std::vector<std::tuple<std::size_t, float, float>> tail;
    bool operator==(const Placed&) const = default;
};

Placed run(const Kernels& kernels, const KernelSquare& square, bool thresholds, bool tail) {
    Placed placed{std::vector<float>(256),
                  std::vector<float>(256),
                  std::vector<float>(256),
                  std::vector<float>(256),
                  {}};
    std::vector<TailDot> tail_dots(256);
    const PlacedCount count = kernels.place(
        square, {placed.x.data(), placed.y.data(), thresholds ? placed.threshold.data() : nullptr,
                 thresholds ? placed.critical.data() : nullptr, tail ? tail_dots.data() : nullptr, 1000});
    for (std::vector<float>* column : {&placed.x, &placed.y, &placed.threshold, &placed.critical}) {
        column->resize(count.dots);
    }
    if (!thresholds) {
        placed.threshold.clear();
        placed.critical.clear();
    }
    for (std::size_t i = 0; i < count.tail; ++i)
        placed.tail.emplace_back(tail_dots[i].index, tail_dots[i].threshold, tail_dots[i].critical);
    return placed;
}

float unit_in(std::mt19937& random) {
    return static_cast<float>(random()) * 0x1p-32f;
}

PointLists some_points(std::mt19937& random) {
    std::vector<CellPoint> points;
    for (std::size_t i = random() % 70; i > 0; --i) {
        const float x = 2 * unit_in(random) - 1, y = 2 * unit_in(random) - 1;
        points.push_back({x, y, 16 + static_cast<float>(points.size())});
    }
    return PointLists({points});
}

// Points along a line, born one after the other from 16 on.
PointLists points_in_line(std::size_t count) {
    std::vector<CellPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        const float at = -1 + 2 * static_cast<float>(i) / static_cast<float>(count);
        points.push_back({at, -at, 16 + static_cast<float>(i)});
    }
    return PointLists({points});
}

// A square of density 1 all over, wherever that comes from.
KernelSquare even_square(const CellPoints& points, KernelSquare::Source source,
                         const std::vector<float>& ones) {
    KernelSquare square;
    square.points = points.blocks();
    square.block_ends = points.block_ends();
    square.centre_x = square.centre_y = 0.5f;
    square.half_x = square.half_y = 0.25f;
    square.ranks_per_density = square.none_from = 1000;
    square.threshold_per_rank = 4;
    square.source = source;
    for (float& v : square.block) v = 1;
    square.pixel_centre_x = square.pixel_centre_y = source == KernelSquare::Source::block ? 1.5 : 8;
    square.pixel_half_x = square.pixel_half_y = 1;
    square.picture = ones.data();
    square.width = square.height = 16;
    return square;
}

constexpr KernelSquare::Source kSources[] = {KernelSquare::Source::block, KernelSquare::Source::picture,
                                             KernelSquare::Source::clamped};

}  // namespace

TEST_CASE(
    "lists of points come back as they were given, and end in an empty block, wherever they are moved") {
    std::mt19937 random(3);
    std::vector<std::vector<CellPoint>> given;
    for (const std::size_t size : {0, 1, 15, 16, 33}) {
        std::vector<CellPoint>& points = given.emplace_back();
        for (std::size_t i = 0; i < size; ++i)
            points.push_back({unit_in(random), unit_in(random), static_cast<float>(i)});
    }
    PointLists first(given);
    const CellPoints last = first[given.size() - 1];
    const PointLists lists = std::move(first);
    CHECK(last.blocks() == lists[given.size() - 1].blocks());
    for (std::size_t k = 0; k < given.size(); ++k) {
        const CellPoints& points = lists[k];
        REQUIRE(points.size() == given[k].size());
        CHECK(points.last_rank() == (given[k].empty() ? 0 : given[k].back().rank));
        for (std::size_t i = 0; i < points.size(); ++i) {
            CHECK(points[i].x == given[k][i].x);
            CHECK(points[i].y == given[k][i].y);
            CHECK(points[i].rank == given[k][i].rank);
        }
        const std::size_t full = points.size() / kBlockPoints;
        for (std::size_t b = 0; b < full; ++b) CHECK(points.block_ends()[b] == given[k][16 * b + 15].rank);
        CHECK(std::isinf(points.block_ends()[full]));
        CHECK(std::isinf(points[points.size()].rank));
    }
}

TEST_CASE("a point exists where density * scale is above its rank, and not where they are equal") {
    const std::vector<float> ones(256, 1.0f);
    const PointLists lists = points_in_line(100);
    const CellPoints& points = lists[0];
    for (const Kernels* kernels : runnable_kernels()) {
        for (const KernelSquare::Source source : kSources) {
            for (const bool thresholds : {false, true}) {
                for (std::size_t count = 0; count < 100; ++count) {
                    CAPTURE(std::string(kernels->name));
                    CAPTURE(static_cast<int>(source));
                    CAPTURE(thresholds);
                    CAPTURE(count);
                    KernelSquare square = even_square(points, source, ones);
                    // Just the rank of the first that is not to be.
                    const float reached = 16 + static_cast<float>(count);
                    square.ranks_per_density = reached;
                    square.tail_per_density = reached - 5;
                    CHECK(run(*kernels, square, thresholds, false).x.size() == count);
                    // Those of the five ranks from the tail scale's own on are the tail.
                    CHECK(run(*kernels, square, thresholds, true).tail.size() ==
                          std::min<std::size_t>(count, 5));
                    square.none_from = reached;
                    CHECK(run(*kernels, square, thresholds, false).x.size() == count);
                    // Bounds may tell at once that those below exist: not those with just that rank.
                    square.certain_below = reached;
                    CHECK(run(*kernels, square, thresholds, false).x.size() == count);
                    std::vector<float> x(256), y(256);
                    const CertainPoints certain =
                        kernels->place_certain(square, {.x = x.data(), .y = y.data()});
                    CHECK(certain.all);
                    CHECK(certain.count == count);
                    // A next number up, and it does exist.
                    square.certain_below = 0;
                    square.none_from = 1000;
                    square.ranks_per_density = std::nextafter(reached, 1000.0f);
                    CHECK(run(*kernels, square, thresholds, false).x.size() == count + 1);
                }
            }
        }
    }
}

TEST_CASE("a point on the window's left or upper edge is in it, one on its right or lower edge is not") {
    const std::vector<float> ones(256, 1.0f);
    const PointLists lists = points_in_line(64);
    const CellPoints& points = lists[0];  // at -1, -31/32, ... and y the other way
    for (const Kernels* kernels : runnable_kernels()) {
        for (const KernelSquare::Source source : kSources) {
            for (const float sign : {1.0f, -1.0f}) {
                for (int at = 1; at < 64; ++at) {
                    CAPTURE(std::string(kernels->name));
                    CAPTURE(sign);
                    CAPTURE(at);
                    const float edge = -1 + static_cast<float>(at) / 32;
                    KernelSquare square = even_square(points, source, ones);
                    square.sign_x = square.sign_y = sign;
                    square.at_edge = true;
                    square.low_x = square.low_y = -2;
                    square.high_x = square.high_y = 2;
                    const auto inside = [&](float& limit, float value) {
                        const float before = std::exchange(limit, value);
                        const std::size_t count = run(*kernels, square, false, false).x.size();
                        limit = before;
                        return static_cast<int>(count);
                    };
                    // Points on the page run from -1 to 31/32, or mirrored from -31/32 to 1.
                    const int before_across = sign > 0 ? at : at - 1, before_down = sign > 0 ? at - 1 : at;
                    CHECK(inside(square.high_x, edge) == before_across);
                    CHECK(inside(square.low_x, edge) == 64 - before_across);
                    CHECK(inside(square.high_y, edge) == before_down);
                    CHECK(inside(square.low_y, edge) == 64 - before_down);
                }
            }
        }
    }
}

TEST_CASE("every kernel that this processor runs places the same dots, to the bit") {
    std::mt19937 random(12);
    const auto unit = [&random] { return unit_in(random); };
    std::vector<float> picture(37 * 29);
    for (float& v : picture) v = 0.2f + unit();

    const std::vector<const Kernels*> all = runnable_kernels();

    std::size_t dots = 0, tail_dots = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const PointLists lists = some_points(random);
        const CellPoints& points = lists[0];
        KernelSquare square;
        square.points = points.blocks();
        square.block_ends = points.block_ends();
        square.swap = random() % 2;
        square.centre_x = unit();
        square.centre_y = unit();
        square.half_x = square.half_y = 0.01f * unit();
        square.ranks_per_density = 120 * unit();
        square.none_from = 2 * square.ranks_per_density;
        square.certain_below =
            random() % 2 ? 0 : 0.19f * square.ranks_per_density;  // as densities are from 0.2
        square.threshold_per_rank = 4;
        square.source = static_cast<KernelSquare::Source>(random() % 3);
        square.sign_x = random() % 2 ? 1.0f : -1.0f;
        square.at_edge = random() % 2;
        square.low_x = -unit();
        square.high_y = unit();
        square.high_x = square.low_y = square.low_x < -0.5f ? 2.0f : 0.0f;
        square.low_y -= 2.0f;
        for (float& v : square.block) v = 0.2f + unit();
        const bool block = square.source == KernelSquare::Source::block;
        const bool clamped = square.source == KernelSquare::Source::clamped;
        square.first_column = static_cast<int>(random() % 1000);
        square.first_row = static_cast<int>(random() % 1000);
        square.pixel_centre_x = block ? square.first_column + 1.5 : clamped ? 60 * unit() : 9 + 19 * unit();
        square.pixel_centre_y = block ? square.first_row + 1.5 : clamped ? 50 * unit() : 9 + 11 * unit();
        square.pixel_half_x = block ? 1.5 : -std::min(8.0, square.pixel_centre_x) * unit();
        square.pixel_half_y = block ? -1.5 * unit() : std::min(8.0, square.pixel_centre_y) * unit();
        square.picture = picture.data();
        square.width = 37;
        square.height = 29;
        square.tail_per_density = 0.9f * square.ranks_per_density;
        if (square.certain_below > 0) square.certain_below = 0.19f * square.tail_per_density;
        for (const bool thresholds : {false, true}) {
            for (const bool tail : {false, true}) {
                const Placed expected = run(kPlainKernels, square, thresholds, tail);
                dots += expected.x.size();
                tail_dots += expected.tail.size();
                for (const Kernels* kernels : all) {
                    if (run(*kernels, square, thresholds, tail) != expected) FAIL("trial ", trial);
                }
                // The tail has the critical scales that its dots have, and the others come before.
                if (!thresholds || !tail) continue;
                std::size_t next = 0;
                for (std::size_t i = 0; i < expected.x.size(); ++i) {
                    const bool listed =
                        next < expected.tail.size() && std::get<0>(expected.tail[next]) == 1000 + i;
                    if (listed)
                        CHECK(expected.tail[next++] ==
                              std::tuple(1000 + i, expected.threshold[i], expected.critical[i]));
                    const float start =
                        expected.threshold[i] / expected.critical[i] * square.tail_per_density;
                    if (listed != !(start > expected.threshold[i] / 4) &&
                        std::abs(start * 4 / expected.threshold[i] - 1) > 1e-5f)
                        FAIL("trial ", trial);
                }
                CHECK(next == expected.tail.size());
            }
        }
    }
    CHECK(dots > 10000);
    CHECK(tail_dots > 1000);
}

TEST_CASE(
    "certain points, and the others behind them, are what testing every point gives, with every kernel") {
    std::mt19937 random(7);
    const auto unit = [&random] { return unit_in(random); };
    const std::vector<const Kernels*> all = runnable_kernels();
    std::size_t decided = 0, partly = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const PointLists lists = some_points(random);
        const CellPoints& points = lists[0];
        KernelSquare square;
        square.points = points.blocks();
        square.block_ends = points.block_ends();
        square.swap = random() % 2;
        square.half_x = square.half_y = 0.01f;
        square.ranks_per_density = 100 * unit();
        square.threshold_per_rank = 4;
        const bool even = random() % 2;
        for (float& v : square.block) v = even ? 1 : 0.8f + 0.2f * unit();
        square.pixel_centre_x = square.pixel_centre_y = 1.5;
        square.pixel_half_x = square.pixel_half_y = 1;
        const auto [least, most] = std::minmax_element(std::begin(square.block), std::end(square.block));
        square.none_from = square.ranks_per_density * *most;
        const Placed expected = run(kPlainKernels, square, false, false);
        square.certain_below = square.ranks_per_density * *least;
        for (const Kernels* kernels : all) {
            Placed placed{std::vector<float>(256), std::vector<float>(256), {}, {}, {}};
            const KernelOutput output{placed.x.data(), placed.y.data()};
            const CertainPoints certain = kernels->place_certain(square, output);
            if (even) CHECK(certain.all);
            square.first = certain.count;
            const std::size_t count = certain.all ? certain.count : kernels->place(square, output).dots;
            square.first = 0;
            for (std::vector<float>* column : {&placed.x, &placed.y}) column->resize(count);
            if (placed != expected) FAIL("trial ", trial);
            decided += !even && certain.all;
            partly += !certain.all && certain.count > 0;
        }
    }
    CHECK(decided > 100);
    CHECK(partly > 100);
}

TEST_CASE("the kernels are the widest that run here, or those asked for by their name") {
    CHECK(kChosen);
    CHECK(chosen_kernels().name == std::string(kWanted ? kWanted : runnable_kernels().back()->name));
    CHECK_THROWS_WITH(choose_kernels("abacus"),
                      doctest::Contains("abacus: not known, or not for this processor, which runs plain"));
}
