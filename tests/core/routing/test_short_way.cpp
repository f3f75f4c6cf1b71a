// The pen's way, against all orders of a few dots and against plain 2-opt.

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include "core/placing/dot_order.h"
#include "core/routing/near_dots.h"
#include "core/routing/short_way.h"
#include "tests/bench/plain_two_opt.h"

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

// Links between all pairs, the shortest first, as long as no dot gets a third link and no ring closes.
double length_of_greedy_links(const Dots& dots) {
    struct Pair {
        double length;
        std::size_t a, b;
        auto operator<=>(const Pair&) const = default;
    };
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < dots.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            pairs.push_back({std::hypot(dots.x[a] - dots.x[b], dots.y[a] - dots.y[b]), a, b});
    std::ranges::sort(pairs);
    std::vector<std::size_t> piece(dots.size()), links(dots.size());
    std::iota(piece.begin(), piece.end(), std::size_t{0});
    double length = 0;
    for (const Pair& pair : pairs) {
        if (links[pair.a] == 2 || links[pair.b] == 2 || piece[pair.a] == piece[pair.b]) continue;
        ++links[pair.a];
        ++links[pair.b];
        length += pair.length;
        std::ranges::replace(piece, std::size_t{piece[pair.a]}, std::size_t{piece[pair.b]});
    }
    return length;
}

// Pairs of a way's links that cross inside both, by comparing all pairs whose ranges from left to right meet.
std::size_t crossings(const Dots& dots, std::span<const std::uint32_t> way) {
    struct Link {
        double left, right, ax, ay, bx, by;
    };
    std::vector<Link> links;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double ax = dots.x[way[i - 1]], ay = dots.y[way[i - 1]], bx = dots.x[way[i]],
                     by = dots.y[way[i]];
        links.push_back({std::min(ax, bx), std::max(ax, bx), ax, ay, bx, by});
    }
    std::ranges::sort(links, {}, &Link::left);
    const auto parts = [](const Link& link, const Link& other) {
        const auto side = [&](double x, double y) {
            return (link.bx - link.ax) * (y - link.ay) - (link.by - link.ay) * (x - link.ax);
        };
        const double one = side(other.ax, other.ay), two = side(other.bx, other.by);
        return (one > 0 && two < 0) || (one < 0 && two > 0);
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < links.size(); ++i)
        for (std::size_t k = i + 1; k < links.size() && links[k].left <= links[i].right; ++k)
            count += parts(links[i], links[k]) && parts(links[k], links[i]);
    return count;
}

double longest_link(const Dots& dots, std::span<const std::uint32_t> way) {
    double longest = 0;
    for (std::size_t i = 1; i < way.size(); ++i)
        longest = std::max(longest, std::hypot(double(dots.x[way[i]]) - dots.x[way[i - 1]],
                                               double(dots.y[way[i]]) - dots.y[way[i - 1]]));
    return longest;
}

// Dark lumps on pale ground, as a photograph has them.
Dots uneven_way_dots(std::size_t count, unsigned seed) {
    Dots dots;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place;
    while (dots.size() < count) {
        const float x = place(random), y = place(random);
        const double dark = 0.02 + std::pow(0.5 + 0.5 * std::sin(20 * x + 3 * std::sin(9 * y)), 6);
        if (place(random) > dark) continue;
        dots.x.push_back(x);
        dots.y.push_back(y);
    }
    sort_dots(dots, DotOrder::space);
    return dots;
}

}  // namespace

TEST_CASE("a greedy way has the links that looking at all pairs finds, but for few that near dots lack") {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Dots dots = random_way_dots(700, seed);
        const std::vector<std::uint32_t> way =
            greedy_way(dots.x, dots.y, near_dots(dots.x, dots.y), false, false);
        CHECK(is_permutation_of_all(way, dots.size()));
        CHECK(way_length(dots.x, dots.y, way) == doctest::Approx(length_of_greedy_links(dots)).epsilon(0.02));
    }
}

TEST_CASE("a greedy way begins and ends with the dots that are held, however few there are") {
    for (const std::size_t count : {2, 3, 4, 5, 9, 40}) {
        for (int held = 0; held < 4; ++held) {
            for (const bool in_one_place : {false, true}) {
                Dots dots = random_way_dots(count, 4);
                if (in_one_place) std::ranges::fill(dots.x, 0.5f), std::ranges::fill(dots.y, 0.5f);
                const bool first = held & 1, last = held & 2;
                const std::vector<std::uint32_t> way =
                    greedy_way(dots.x, dots.y, near_dots(dots.x, dots.y), first, last);
                CHECK(is_permutation_of_all(way, count));
                if (first) CHECK(way.front() == 0);
                if (last) CHECK(way.back() == count - 1);
            }
        }
    }
}

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

TEST_CASE("the way through a hundred thousand dots is within 5.2 % of the shortest that so many have") {
    const Dots dots = random_way_dots(100'000, 7);
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y);
    CHECK(is_permutation_of_all(order, dots.size()));
    // 0.7124 sqrt(n A) for dots all over a page (Applegate and others 2006).
    CHECK(way_length(dots.x, dots.y, order) < 1.052 * 0.7124 * std::sqrt(100'000.0));
}

TEST_CASE("no two links of a way cross, and none is long where there are dots") {
    const auto check = [](const Dots& dots) {
        const std::vector<std::uint32_t> way = short_way(dots.x, dots.y);
        CHECK(is_permutation_of_all(way, dots.size()));
        CHECK(crossings(dots, way) == 0);
        return way;
    };
    for (const std::size_t count : {4, 5, 30, 300, 2000})
        for (const unsigned seed : {1u, 2u, 3u}) {
            check(uneven_way_dots(count, seed));
            const Dots dots = random_way_dots(count, seed);
            CHECK(longest_link(dots, check(dots)) < 6 / std::sqrt(double(count)));
        }
    // Several windows of consecutive dots, whose borders were crossed.
    const Dots many = random_way_dots(12'000, 8);
    CHECK(longest_link(many, check(many)) < 6 / std::sqrt(12'000.0));
    check(uneven_way_dots(12'000, 9));
}

TEST_CASE("where many dots lie on one line, or in one place, links do not cross either") {
    Dots lattice;
    for (int i = 0; i < 900; ++i) {
        lattice.x.push_back(0.03f * float(i % 30));
        lattice.y.push_back(0.03f * float(i / 30));
    }
    Dots doubled = lattice;
    append(doubled, lattice);
    for (int i = 0; i < 40; ++i) doubled.x.push_back(0.5f), doubled.y.push_back(0.5f);
    Dots row = random_way_dots(500, 2);
    std::ranges::fill(row.y, 0.25f);
    for (Dots* dots : {&lattice, &doubled, &row}) {
        sort_dots(*dots, DotOrder::space);
        const std::vector<std::uint32_t> way = short_way(dots->x, dots->y);
        CHECK(is_permutation_of_all(way, dots->size()));
        CHECK(crossings(*dots, way) == 0);
    }
    CHECK(way_length(row.x, row.y, short_way(row.x, row.y)) == doctest::Approx(1).epsilon(0.01));
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
