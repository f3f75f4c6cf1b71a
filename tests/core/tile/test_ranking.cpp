#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "core/tile/ranking.h"
#include "lab/search/relink_search.h"

using namespace dapple;

TEST_CASE("ranks are a permutation: the tile's own points first, then its children's newborn ones") {
    for (const Rule& rule :
         {Rule{}, Rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}}}) {
        const Tile tile = make_tile(rule, {"0301213303211022"});
        for (const RankingMethod method : {RankingMethod::farthest, RankingMethod::energy}) {
            const Ranking ranking = rank(tile, method);
            std::set<float> ranks(ranking.tile.begin(), ranking.tile.end());
            CHECK(ranks.size() == 16);
            CHECK(*ranks.rbegin() == 15.5f);
            ranks.insert(ranking.newborn.begin(), ranking.newborn.end());
            CHECK(ranks.size() == 64);
            CHECK(*ranks.rbegin() == 63.5f);
        }
    }
}

TEST_CASE(
    "farthest-point ranks: each point that appears is, on the mean, the one farthest from all before it") {
    const Tile tile = make_tile(Rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}},
                                {"0301213303211022", "2011>3", "33121>17", "002>7", "2211>9"});
    const auto neighbours = legal_neighbours(tile.rule);
    const Ranking ranking = rank(tile, RankingMethod::farthest);
    std::vector<std::pair<float, glm::dvec2>> ranks;
    for (std::size_t i = 0; i < tile.size(); ++i)
        ranks.emplace_back(ranking.tile[i], to_unit_square(tile.points[i]));
    const auto newborns = newborns_of(tile);
    for (std::size_t i = 0; i < newborns.size(); ++i)
        ranks.emplace_back(ranking.newborn[i], to_unit_square(newborns[i].position));
    std::sort(ranks.begin(), ranks.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

    const auto squared = [](glm::dvec2 d) { return d.x * d.x + d.y * d.y; };
    const auto distance = [&](glm::dvec2 p, std::size_t count) {
        double own = 10;
        for (std::size_t j = 0; j < count; ++j) own = std::min(own, squared(p - ranks[j].second));
        double nearest = own;
        for (int place = 0; place < 9; ++place) {
            const glm::ivec2 offset(place % 3 - 1, place / 3 - 1);
            double mean = 0, all = 0;
            for (const Neighbour& n : neighbours) {
                if (n.offset != offset) continue;
                double with_it = own;
                for (std::size_t j = 0; j < count; ++j)
                    with_it = std::min(with_it, squared(p - position_in(n, ranks[j].second)));
                mean += n.probability * with_it;
                all += n.probability;
            }
            if (all > 0) nearest = std::min(nearest, mean);
        }
        return nearest;
    };
    for (std::size_t k = 1; k < ranks.size(); ++k) {
        const double chosen = distance(ranks[k].second, k);
        const std::size_t end = k < tile.size() ? tile.size() : ranks.size();
        for (std::size_t other = k + 1; other < end; ++other)
            CHECK(distance(ranks[other].second, k) <= chosen + 1e-9);
    }
}

TEST_CASE("neither order leaves a tile's border to the end") {
    const Tile tile = make_tile(Rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}},
                                even_words(1024, 4));
    const auto newborns = newborns_of(tile);
    for (const RankingMethod method : {RankingMethod::farthest, RankingMethod::energy}) {
        const Ranking ranking = rank(tile, method);
        for (const double shown : {512.0, 1500.0, 2500.0, 3300.0}) {
            CAPTURE(shown);
            // As wide as two dots are apart.
            const double strip = 1 / std::sqrt(shown);
            int held = 0;
            const auto count = [&](BinaryPoint point, float rank) {
                const glm::dvec2 p = to_unit_square(point);
                held += rank < shown && std::min({p.x, p.y, 1 - p.x, 1 - p.y}) < strip;
            };
            for (std::size_t i = 0; i < tile.size(); ++i) count(tile.points[i], ranking.tile[i]);
            for (std::size_t i = 0; i < newborns.size(); ++i) count(newborns[i].position, ranking.newborn[i]);
            const double even = shown * (1 - std::pow(1 - 2 * strip, 2));
            CHECK(held > 0.85 * even);
            CHECK(held < 1.15 * even);
        }
    }
}

TEST_CASE("the energy order of a larger tile fills every quarter of it at the same pace") {
    const Tile tile =
        make_tile(Rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}}, even_words(256, 4));
    const Ranking ranking = rank(tile, RankingMethod::energy);
    for (const float shown : {64.0f, 128.0f, 400.0f, 700.0f}) {
        std::array<int, 16> held{};
        const auto count = [&](BinaryPoint p, float rank) {
            if (rank >= shown) return;
            const glm::dvec2 at = to_unit_square(p) * 4.0;
            ++held[std::size_t(at.y) * 4 + std::size_t(at.x)];
        };
        const auto newborns = newborns_of(tile);
        for (std::size_t i = 0; i < tile.size(); ++i) count(tile.points[i], ranking.tile[i]);
        for (std::size_t i = 0; i < newborns.size(); ++i) count(newborns[i].position, ranking.newborn[i]);
        for (const int n : held) {
            // By chance the deviation would be sqrt(mean): 5 at 400 points, 6.6 at 700.
            CHECK(n >= shown / 16 - 4.0f);
            CHECK(n <= shown / 16 + 4.0f);
        }
    }
}

TEST_CASE(
    "the paper's tile has the ranks of Appendix A: greedy farthest point on the torus from (14217, 2895)") {
    // Worked out from the two integers alone, in units of 1 / 65535 and without rounding.
    constexpr long kPeriod = 65535;
    std::vector<std::array<long, 2>> points{{14217, 2895}};
    while (points.size() < 16)
        points.push_back({points.back()[0] * 2 % kPeriod, points.back()[1] * 2 % kPeriod});
    const auto apart = [&](std::size_t i, std::size_t j) {
        long sum = 0;
        for (int axis = 0; axis < 2; ++axis) {
            const long d = std::abs(points[i][axis] - points[j][axis]);
            sum += std::min(d, kPeriod - d) * std::min(d, kPeriod - d);
        }
        return sum;
    };
    const std::vector<int> ranks = farthest_point_ranks(make_tile(14217, 2895, 16));
    std::vector<std::size_t> order(16);
    for (std::size_t i = 0; i < 16; ++i) order[ranks[i]] = i;
    CHECK(order[0] == 0);
    const auto gap = [&](std::size_t i, std::size_t placed) {
        long nearest = std::numeric_limits<long>::max();
        for (std::size_t k = 0; k < placed; ++k) nearest = std::min(nearest, apart(i, order[k]));
        return nearest;
    };
    for (std::size_t k = 1; k < 16; ++k) {
        for (std::size_t later = k; later < 16; ++later) CHECK(gap(order[k], k) >= gap(order[later], k));
    }
}
