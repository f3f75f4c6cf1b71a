// Tiles of several kinds, against subdivisions carried out in full.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "core/tile/tile_file.h"
#include "lab/search/criteria.h"
#include "lab/search/ranking_search.h"
#include "lab/search/tile_marks.h"
#include "tests/densities.h"

namespace dapple {
namespace {

struct Placed {
    Orientation orientation;
    std::size_t kind = 0;
};

// The tiles of a level, row by row.
std::vector<std::vector<Placed>> subdivided(const Rule& rule, const NextKinds& next, int levels) {
    std::vector<std::vector<Placed>> tiles{{Placed{}}};
    for (int level = 0; level < levels; ++level) {
        const std::size_t n = tiles.size();
        std::vector<std::vector<Placed>> children(2 * n, std::vector<Placed>(2 * n));
        for (std::size_t y = 0; y < n; ++y) {
            for (std::size_t x = 0; x < n; ++x) {
                const Placed& tile = tiles[y][x];
                for (int q = 0; q < 4; ++q) {
                    const int at = apply_to_quadrant(tile.orientation, q);
                    const auto quadrant = static_cast<std::size_t>(q);
                    children[2 * y + static_cast<std::size_t>(at >> 1)]
                            [2 * x + static_cast<std::size_t>(at & 1)] = {
                                compose(tile.orientation, rule.child[quadrant]), next[tile.kind][quadrant]};
                }
            }
        }
        tiles = std::move(children);
    }
    return tiles;
}

std::string reason_against(const std::string& text) {
    try {
        read_tile(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

std::string with(std::string text, const std::string& piece, const std::string& by) {
    const std::size_t at = text.find(piece);
    REQUIRE(at != std::string::npos);
    return text.replace(at, piece.size(), by);
}

}  // namespace

TEST_CASE("a kind's points in a quadrant are points of the kind of the child there, half as large") {
    for (const Rule& rule : {Rule{}, kTurning}) {
        const Tile tile = random_kinds(rule, kThreeKinds, 64, 3);
        CHECK(tile.kinds() == 3);
        CHECK(tile.size() == 64);
        CHECK(tile.points.size() == 192);
        for (std::size_t i = 0; i < tile.points.size(); ++i) {
            const auto q = static_cast<std::size_t>(quadrant_of(tile.points[i]));
            const glm::dvec2 child =
                to_unit_square(apply(inverse(rule.child[q]), enlarge_quadrant(tile.points[i])));
            const glm::dvec2 successor = to_unit_square(tile.points[tile.successor[i]]);
            CHECK(std::abs(child.x - successor.x) + std::abs(child.y - successor.y) < 1e-15);
            CHECK(tile.kind_of(tile.successor[i]) == kThreeKinds[tile.kind_of(i)][q]);
        }
    }
}

TEST_CASE("with the points that its children add, a kind has all points of its children") {
    const Tile tile = random_kinds(kTurning, kThreeKinds, 20, 8);
    const auto newborns = newborns_of(tile);
    REQUIRE(newborns.size() == 180);
    for (std::size_t k = 0; k < 3; ++k) {
        std::set<std::pair<double, double>> points, children;
        const auto rounded = [](glm::dvec2 p) {
            return std::pair{std::round(p.x * 1e12), std::round(p.y * 1e12)};
        };
        for (std::size_t i = 20 * k; i < 20 * (k + 1); ++i)
            points.insert(rounded(to_unit_square(tile.points[i])));
        for (std::size_t i = 60 * k; i < 60 * (k + 1); ++i)
            points.insert(rounded(to_unit_square(newborns[i].position)));
        for (int q = 0; q < 4; ++q) {
            const auto quadrant = static_cast<std::size_t>(q);
            const std::size_t first = kThreeKinds[k][quadrant] * std::size_t{20};
            for (std::size_t i = first; i < first + 20; ++i) {
                const BinaryPoint turned = apply(tile.rule.child[quadrant], tile.points[i]);
                children.insert(rounded(to_unit_square(shrink_to_quadrant(q, turned))));
            }
        }
        CHECK(points.size() == 80);
        CHECK(points == children);
    }
}

TEST_CASE("kinds that cannot be are refused") {
    const NextKinds two{{0, 1, 1, 0}, {1, 0, 0, 1}};
    const std::string letters = "01230123";
    CHECK_NOTHROW(make_tile(Rule{}, two, letters, {0, 4, 5, 1, 4, 0, 1, 5}));
    CHECK_THROWS_AS(make_tile(Rule{}, two, letters, {0, 1, 5, 1, 4, 0, 1, 5}), std::runtime_error);
    CHECK_THROWS_AS(make_tile(Rule{}, two, std::string("00000000"), {0, 0, 0, 0, 4, 4, 4, 4}),
                    std::runtime_error);
    CHECK_THROWS_AS(make_tile(Rule{}, {{0, 2, 1, 0}, {1, 0, 0, 1}}, letters, {0, 4, 5, 1, 4, 0, 1, 5}),
                    std::runtime_error);
    CHECK_THROWS_AS(make_tile(Rule{}, {}, std::string(), {}), std::runtime_error);
}

TEST_CASE("neighbours of several kinds are those that a subdivision shows, as often as it does") {
    for (const Rule& rule : {Rule{}, kTurning}) {
        const auto neighbours = legal_neighbours(rule, kThreeKinds);
        const auto tiles = subdivided(rule, kThreeKinds, 9);
        const int n = static_cast<int>(tiles.size());
        std::map<std::array<int, 5>, double> seen;
        std::map<std::array<int, 3>, double> at_offset;
        for (int y = 1; y + 1 < n; ++y) {
            for (int x = 1; x + 1 < n; ++x) {
                const Placed& tile = tiles[std::size_t(y)][std::size_t(x)];
                const Orientation frame = inverse(tile.orientation);
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        if (dx == 0 && dy == 0) continue;
                        const Placed& other = tiles[std::size_t(y + dy)][std::size_t(x + dx)];
                        const glm::ivec2 offset(apply(frame, glm::dvec2(dx, dy)));
                        const Orientation turn = compose(frame, other.orientation);
                        const int of = static_cast<int>(tile.kind), kind = static_cast<int>(other.kind);
                        ++seen[{of, offset.x, offset.y, kind, turn.index}];
                        ++at_offset[{of, offset.x, offset.y}];
                    }
                }
            }
        }
        CHECK(seen.size() == neighbours.size());
        for (const Neighbour& o : neighbours) {
            const auto found = seen.find({o.of, o.offset.x, o.offset.y, o.kind, o.orientation.index});
            REQUIRE(found != seen.end());
            const double share = found->second / at_offset[{o.of, o.offset.x, o.offset.y}];
            CHECK(std::abs(share - o.probability) < 0.02);
        }
    }
}

TEST_CASE("how often tiles are of one kind is what a subdivision shows") {
    const int lags = 9;
    const auto highest = kind_coincidence(kThreeKinds, lags);
    const auto tiles = subdivided(Rule{}, kThreeKinds, 9);
    const int side = static_cast<int>(tiles.size());
    REQUIRE(highest.size() == lags);
    for (int lag = 1; lag <= lags; ++lag) {
        double most = 0;
        for (int dy = 0; dy <= lag; ++dy) {
            for (int dx = -lag; dx <= lag; ++dx) {
                if (std::max(std::abs(dx), dy) != lag) continue;
                double equal = 0, all = 0;
                for (int y = 0; y + dy < side; ++y) {
                    for (int x = std::max(0, -dx); x < side && x + dx < side; ++x) {
                        equal += tiles[std::size_t(y)][std::size_t(x)].kind ==
                                 tiles[std::size_t(y + dy)][std::size_t(x + dx)].kind;
                        ++all;
                    }
                }
                most = std::max(most, equal / all);
            }
        }
        CHECK(highest[std::size_t(lag - 1)] == doctest::Approx(most).epsilon(0.03));
    }
    for (const double share : kind_coincidence(NextKinds(1), 5)) CHECK(share == doctest::Approx(1));
}

TEST_CASE("how much of a page lies on its own kind when it is moved, at worst") {
    const NextKinds board{{0, 1, 1, 0}, {1, 0, 0, 1}}, pair{{0, 0, 1, 2}, {1, 2, 0, 0}, {2, 1, 2, 1}};
    const NextKinds four{{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    CHECK(page_coincidence(board, 1) == 1);  // by one to the right and one up
    CHECK(page_coincidence(pair, 1) == 0.5);
    CHECK(page_coincidence(four, 1) == 0);
    CHECK(page_coincidence(four, 2) == 0.5);  // 0110, 2332, 2332, 0110: by two rows
}

TEST_CASE("all kinds are ranked together, as many points of each in every stage") {
    const Tile tile = random_kinds(Rule{}, kThreeKinds, 64, 5);
    RankingSearchSettings settings;
    settings.exchanges = 20'000;
    const Ranking greedy = rank(tile, RankingMethod::energy), searched = search_ranking(tile, settings);
    for (const Ranking& ranking : {greedy, searched}) {
        std::vector<float> own = ranking.tile;
        std::ranges::sort(own);
        REQUIRE(own.size() == 64);
        for (std::size_t i = 0; i < 64; ++i) CHECK(own[i] == static_cast<float>(i) + 0.5f);
        REQUIRE(ranking.newborn.size() == 576);
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<float> newborn(ranking.newborn.begin() + static_cast<std::ptrdiff_t>(192 * k),
                                       ranking.newborn.begin() + static_cast<std::ptrdiff_t>(192 * (k + 1)));
            std::ranges::sort(newborn);
            for (std::size_t i = 0; i < 192; ++i) CHECK(newborn[i] == static_cast<float>(64 + i) + 0.5f);
        }
        CHECK(ranks_of_stages(64, stages_of_ranks(64, ranking.newborn)) == ranking.newborn);
    }
    CHECK(ranking_energy(tile, searched, settings) < ranking_energy(tile, greedy, settings));
    CHECK(born_until(64, kRankStages - 1) == 192);
    CHECK_THROWS_AS(rank(tile, RankingMethod::farthest), std::runtime_error);
}

TEST_CASE("kinds that are all alike have the numbers of the one kind that they are") {
    const Tile one = random_tile(Rule{}, 64, 4);
    std::string letters;
    std::vector<std::uint32_t> successor;
    const NextKinds two{{0, 1, 1, 0}, {1, 1, 0, 0}};
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < 64; ++i) {
            const auto q = static_cast<std::size_t>(quadrant_of(one.points[i]));
            letters += static_cast<char>('0' + q);
            successor.push_back(two[k][q] * 64 + one.successor[i]);
        }
    }
    const Tile both = make_tile(Rule{}, two, letters, successor);
    CHECK(relative_radius(both) == doctest::Approx(relative_radius(one)));
    CHECK(low_frequency_power(both) == doctest::Approx(low_frequency_power(one)));
    CHECK(coherent_share(both) == doctest::Approx(coherent_share(one)));
    CHECK(lattice_share(both) == doctest::Approx(lattice_share(one)));
    CHECK(headline(both) == "2 kinds of 64 points, rule 0000");
}

TEST_CASE("a tile of several kinds is read as it was written") {
    for (const std::uint32_t points : {20u, 64u}) {
        const StoredTile stored =
            ranked(random_kinds(kTurning, kThreeKinds, points, points), RankingMethod::energy);
        const StoredTile read = read_tile(write_tile(stored, std::vector<std::string>{"a comment"}));
        CHECK(read.tile.rule == stored.tile.rule);
        CHECK(read.tile.next_kind == stored.tile.next_kind);
        CHECK(read.tile.points == stored.tile.points);
        CHECK(read.tile.successor == stored.tile.successor);
        CHECK(read.method == stored.method);
        CHECK(read.ranking.tile == stored.ranking.tile);
        CHECK(read.ranking.newborn == stored.ranking.newborn);
    }
}

TEST_CASE("a malformed file of several kinds is refused with its line and a reason") {
    // Two kinds of four points, one in each quadrant.
    const std::string good = [&] {
        const Tile tile = make_tile(Rule{}, {{0, 1, 1, 0}, {1, 0, 0, 1}}, std::string("01230123"),
                                    {0, 4, 5, 1, 6, 2, 3, 7});
        return write_tile(ranked(tile, RankingMethod::energy));
    }();
    REQUIRE(reason_against(good) == "");
    struct Case {
        std::string piece, by, line, reason;
    };
    const std::vector<Case> cases{
        {"kinds 2", "kinds 1", "line 3: ", "from 2 to 64"},
        {"kinds 2", "kinds 3", "line 8: ", "four kinds"},
        {"points 4", "points 4098", "line 4: ", "from 4 to 4096"},
        {"0 1 1 0", "0 1 2 0", "line 6: ", "from 0 to 1"},
        {"0 1 1 0", "0 1 1", "line 6: ", "four kinds"},
        {"successors\n", "successors\n=\n", "line 9: ", "base64"},
        {"successors\n", "successors\nAAAA\n", "line 9: ", "3 bytes"},
        {"successors\n", "successors\nAA==\n", "line 12: ", "kind 0 has 3 points"},
        {"ranking energy", "ranking best", "line 17: ", "not known"},
        {"ranks\n", "ranks\nAAAAAAAA\n", "line 19: ", "comes twice"},
        {"newborn stages\n", "newborn stages\nAAAAAAAA\n", "line 21: ", "by the end of stage 0"},
        {"end\n", "end\nmore\n", "line 24: ", "more after 'end'"},
    };
    for (const Case& c : cases) {
        const std::string reason = reason_against(with(good, c.piece, c.by));
        CAPTURE(c.by);
        CAPTURE(reason);
        CHECK(reason.starts_with(c.line));
        CHECK(reason.find(c.reason) != std::string::npos);
    }
    for (std::size_t cut = 0; cut < good.size() - 1; ++cut) CHECK(reason_against(good.substr(0, cut)) != "");
}

}  // namespace dapple
