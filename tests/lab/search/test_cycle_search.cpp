#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/tile/tile.h"
#include "lab/search/cycle_search.h"

using namespace dapple;

namespace {

// The oracle: points as integers over 15, doubled modulo it, all sets of cycles looked at, no words involved.
using Point = std::pair<int, int>;
using Points = std::vector<Point>;

// 15 of 15 is doubled to itself, and the same place as 0 on the torus.
int doubled(int x) {
    return x == 15 ? 15 : 2 * x % 15;
}

std::vector<Points> cycles_of_four() {
    std::set<Points> cycles;
    for (int x = 0; x <= 15; ++x)
        for (int y = 0; y <= 15; ++y) {
            Points cycle{{x, y}};
            for (int i = 0; i < 3; ++i)
                cycle.push_back({doubled(cycle.back().first), doubled(cycle.back().second)});
            std::ranges::sort(cycle);
            if (std::ranges::adjacent_find(cycle) == cycle.end()) cycles.insert(cycle);
        }
    return {cycles.begin(), cycles.end()};
}

int squared_distance(Point p, Point q) {
    const int dx = std::abs(p.first - q.first) % 15, dy = std::abs(p.second - q.second) % 15;
    const int mx = std::min(dx, 15 - dx), my = std::min(dy, 15 - dy);
    return mx * mx + my * my;
}

// The smallest distance, squared, of each balanced set of so many cycles, and all sets that have it.
std::map<int, std::set<Points>> all_sets(std::size_t count) {
    const std::vector<Points> cycles = cycles_of_four();
    REQUIRE(cycles.size() == 60);
    std::vector<std::vector<int>> nearest(60, std::vector<int>(60, 1000));
    for (std::size_t i = 0; i < 60; ++i)
        for (std::size_t j = 0; j < 60; ++j)
            for (const Point& p : cycles[i])
                for (const Point& q : cycles[j])
                    if (p != q) nearest[i][j] = std::min(nearest[i][j], squared_distance(p, q));
    std::map<int, std::set<Points>> sets;
    std::vector<std::size_t> chosen;
    const std::function<void(std::size_t, int)> choose = [&](std::size_t first, int smallest) {
        if (chosen.size() == count) {
            Points points;
            std::array<std::size_t, 4> inside{};
            for (const std::size_t i : chosen)
                for (const Point& p : cycles[i]) {
                    points.push_back(p);
                    ++inside[std::size_t(p.first >= 8) + 2 * std::size_t(p.second >= 8)];
                }
            if (std::ranges::count(inside, count) != 4) return;
            std::ranges::sort(points);
            sets[smallest].insert(points);
            return;
        }
        for (std::size_t i = first; i < 60; ++i) {
            int now = std::min(smallest, nearest[i][i]);
            for (const std::size_t j : chosen) now = std::min(now, nearest[i][j]);
            if (now < 2) continue;  // of no interest, and most
            chosen.push_back(i);
            choose(i + 1, now);
            chosen.pop_back();
        }
    };
    choose(0, 1000);
    return sets;
}

double radius_of(int squared, std::size_t points) {
    return std::sqrt(squared) / 15 / 2 * std::sqrt(2 * std::sqrt(3.0) * double(points));
}

// The tile's eight images.
std::set<Points> images_of(const FoundCycles& found) {
    Points points;
    for (const std::string& word : found.words)
        for (std::size_t start = 0; start < 4; ++start) {
            Point p{0, 0};
            for (std::size_t i = 0; i < 4; ++i) {
                const int letter = word.at((start + i) % 4) - '0';
                p = {2 * p.first + letter % 2, 2 * p.second + letter / 2};
            }
            points.push_back(p);
        }
    std::set<Points> images;
    for (int g = 0; g < 8; ++g) {
        Points image;
        for (auto [x, y] : points) {
            if (g & 1) x = 15 - x;
            if (g & 2) y = 15 - y;
            if (g & 4) std::swap(x, y);
            image.emplace_back(x, y);
        }
        std::ranges::sort(image);
        images.insert(image);
    }
    return images;
}

}  // namespace

TEST_CASE("the best sets of four and five cycles of four points are those of all that there are") {
    for (const std::size_t count : {std::size_t{4}, std::size_t{5}}) {
        CAPTURE(count);
        std::map<int, std::set<Points>> expected = all_sets(count), found;
        const CycleSearchResult result = search_cycles(std::vector<int>(count, 4), 1000);
        CHECK(result.finished);
        std::size_t tiles = 0;
        for (const FoundCycles& tile : result.best) {
            const auto same = std::ranges::find_if(expected, [&](const auto& one) {
                return std::abs(radius_of(one.first, 4 * count) - tile.relative_radius) < 1e-12;
            });
            if (same == expected.end()) continue;  // below 2
            ++tiles;
            for (const Points& image : images_of(tile)) CHECK(found[same->first].insert(image).second);
        }
        CHECK(found == expected);
        CHECK(tiles < result.best.size());
    }
}

TEST_CASE("four cycles make a better tile than one: three of 0.744484 up to symmetry, seven in all") {
    const std::vector<FoundCycles> best = search_cycles({4, 4, 4, 4}, 4).best;
    REQUIRE(best.size() == 4);
    std::set<Points> images;
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::lround(best[i].relative_radius * 1e6) == 744484);
        images.merge(images_of(best[i]));
    }
    CHECK(images.size() == 7);
    CHECK(best[0].words == std::vector<std::string>{"0013", "0211", "0233", "1322"});
    CHECK(best[2].words == std::vector<std::string>{"0103", "0212", "0323", "1213"});
    CHECK(best[3].relative_radius < 0.6);
    // Fewer are the first of these, also where the next one is as good.
    for (std::size_t top = 1; top < 4; ++top)
        CHECK(search_cycles({4, 4, 4, 4}, top).best ==
              std::vector(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(top)));
}

TEST_CASE("the best sets of four-point cycles have the radii that another program found") {
    const auto best = [](std::size_t cycles) {
        return std::lround(search_cycles(std::vector<int>(cycles, 4), 1).best.at(0).relative_radius * 1e6);
    };
    CHECK(best(4) == 744484);
    CHECK(best(5) == 832358);
    CHECK(best(6) == 679618);
    CHECK(best(7) == 734071);
}

TEST_CASE("cycles of different lengths are put together too") {
    for (const std::vector<int>& lengths : {std::vector{1, 3}, {3, 5}, {2, 4, 6}}) {
        const std::vector<FoundCycles> best = search_cycles(lengths, 20).best;
        REQUIRE(!best.empty());
        for (const FoundCycles& found : best) {
            std::vector<int> given;
            for (const std::string& word : found.words) given.push_back(int(word.size()));
            std::ranges::sort(given);
            CHECK(given == lengths);
            const Tile tile = make_tile(Rule{}, found.words);
            const double n = double(tile.size());
            double nearest = 2;
            std::array<std::size_t, 4> inside{};
            for (std::size_t i = 0; i < tile.size(); ++i) {
                const glm::dvec2 p = to_unit_square(tile.points[i]);
                ++inside[std::size_t(quadrant_of(tile.points[i]))];
                for (std::size_t j = 0; j < i; ++j) {
                    const glm::dvec2 apart = p - to_unit_square(tile.points[j]);
                    nearest = std::min(
                        nearest, std::hypot(apart.x - std::round(apart.x), apart.y - std::round(apart.y)));
                }
            }
            CHECK(std::ranges::count(inside, tile.size() / 4) == 4);
            CHECK(found.relative_radius ==
                  doctest::Approx(nearest / 2 * std::sqrt(2 * std::sqrt(3.0) * n)).epsilon(1e-9));
        }
    }
}

TEST_CASE("the search for cycles stops when asked, and refuses what cannot be") {
    std::stop_source source;
    source.request_stop();
    CHECK(!search_cycles({6, 6, 6, 6}, 5, source.get_token()).finished);
    CHECK_THROWS_WITH_AS(search_cycles({4, 5}, 5), doctest::Contains("multiple of 4"), std::runtime_error);
    for (const std::vector<int>& lengths : {std::vector<int>{}, {0, 4}, {7, 1}})
        CHECK_THROWS_WITH_AS(search_cycles(lengths, 5), "cycles can have 1 to 6 points", std::runtime_error);
}
