// The pen's way, against all orders of a few dots and against plain 2-opt.

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "bench/plain_two_opt.h"
#include "core/placing/dot_order.h"
#include "core/routing/near_dots.h"
#include "core/routing/short_way.h"

namespace dapple {
namespace {

Dots random_way_dots(std::size_t count, unsigned seed) {
    Dots dots;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place;
    for (std::size_t i = 0; i < count; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random));
    }
    sort_dots(dots, DotOrder::space);
    return dots;
}

bool is_permutation_of_all(std::vector<std::uint32_t> order, std::size_t count) {
    std::ranges::sort(order);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return order == all;
}

}  // namespace

TEST_CASE("the way through eight dots is nearly the shortest of all there are") {
    double found = 0, shortest = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Dots dots = random_way_dots(8, seed);
        const double way = way_length(dots.x, dots.y, short_way(dots.x, dots.y));
        std::vector<std::uint32_t> order(8);
        std::iota(order.begin(), order.end(), 0u);
        double best = way_length(dots.x, dots.y);
        while (std::ranges::next_permutation(order).found)
            best = std::min(best, way_length(dots.x, dots.y, order));
        CHECK(way >= best - 1e-9);
        found += way;
        shortest += best;
    }
    CHECK(found < 1.02 * shortest);
}

TEST_CASE("the way through two thousand dots is shorter than by plain 2-opt, and visits each dot once") {
    const Dots dots = random_way_dots(2000, 3);
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y);
    CHECK(is_permutation_of_all(order, dots.size()));
    const double way = way_length(dots.x, dots.y, order);
    CHECK(way < way_length(dots.x, dots.y, plain_two_opt(dots)));
    CHECK(way < 0.8 * way_length(dots.x, dots.y));
}

TEST_CASE("the way through a hundred thousand dots is within 6 % of the shortest that so many have") {
    const Dots dots = random_way_dots(100'000, 7);
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y);
    CHECK(is_permutation_of_all(order, dots.size()));
    // 0.7124 sqrt(n A) for dots all over a page (Applegate and others 2006).
    CHECK(way_length(dots.x, dots.y, order) < 1.06 * 0.7124 * std::sqrt(100'000.0));
}

TEST_CASE("a way is the same with any number of threads, and its progress never goes back") {
    const Dots dots = random_way_dots(25'000, 4);
    double last = 0;
    bool ascends = true;
    const std::vector<std::uint32_t> order =
        short_way(dots.x, dots.y, {.stop = {}, .progress = [&](double share) {
                                       ascends = ascends && share >= last;
                                       last = share;
                                   }});
    CHECK(ascends);
    CHECK(last == doctest::Approx(1));
    CHECK(is_permutation_of_all(order, dots.size()));
    CHECK(way_length(dots.x, dots.y, order) < 0.8 * way_length(dots.x, dots.y));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(short_way(dots.x, dots.y) == order);
}

TEST_CASE("a way that is stopped, or has hardly any dots or all in one place, is none the longer") {
    std::stop_source stopped;
    stopped.request_stop();
    const Dots dots = random_way_dots(500, 5);
    CHECK(
        is_permutation_of_all(short_way(dots.x, dots.y, {.stop = stopped.get_token(), .progress = {}}), 500));
    for (const std::size_t count : {0, 1, 2, 3, 4, 300}) {
        const std::vector<float> same(count, 0.5f);
        CHECK(is_permutation_of_all(short_way(same, same), count));
    }
}

TEST_CASE("near dots are those found by comparing all pairs") {
    const Dots dots = random_way_dots(400, 6);
    const std::vector<std::uint32_t> near = near_dots(dots.x, dots.y);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const auto away = [&](std::size_t k) {
            return std::hypot(dots.x[i] - dots.x[k], dots.y[i] - dots.y[k]);
        };
        std::vector<float> all;
        for (std::size_t k = 0; k < dots.size(); ++k)
            if (k != i) all.push_back(away(k));
        std::ranges::sort(all);
        for (std::size_t k = 0; k < kNearDots; ++k)
            REQUIRE(away(near[i * kNearDots + k]) == doctest::Approx(all[k]));
    }
}

}  // namespace dapple
