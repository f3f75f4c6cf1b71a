#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/tile/tile.h"
#include "tests/tile_words.h"

using namespace dapple;

TEST_CASE("the paper's tile is the cycle of 2x mod 1 through (14217, 2895) / 65535") {
    const Tile tile = make_tile(14217, 2895, 16);
    REQUIRE(tile.size() == 16);
    long a = 14217, b = 2895;
    for (std::size_t i = 0; i < 16; ++i) {
        const glm::dvec2 p = to_unit_square(tile.points[i]);
        CHECK(p.x == doctest::Approx(double(a) / 65535).epsilon(1e-14));
        CHECK(p.y == doctest::Approx(double(b) / 65535).epsilon(1e-14));
        a = a * 2 % 65535;
        b = b * 2 % 65535;
    }
}

TEST_CASE("a tile is its words, with any rule") {
    const Rule rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
    const Tile tile = make_tile(rule, {"0123121333013221", "0221"});
    const auto words = words_of(tile.points, rule);
    REQUIRE(words.size() == 2);
    CHECK(words[1] == "0221");
    const Tile again = make_tile(rule, words);
    for (const BinaryPoint p : tile.points) {
        CHECK(std::count(again.points.begin(), again.points.end(), p) == 1);
    }
}

TEST_CASE("a tile of cycles and tails is its words, whatever the order of its points") {
    const Rule rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
    // The points 3 and 5 share the successor 0; the third word hangs on the second.
    const Tile tile = make_tile(rule, {"0312", "11>0", "33>4"});
    CHECK(tile.successor == std::vector<std::uint32_t>{1, 2, 3, 0, 5, 0, 7, 4});
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const BinaryPoint p = tile.points[i];
        const int q = quadrant_of(p);
        const glm::dvec2 again =
            to_unit_square(shrink_to_quadrant(q, apply(rule.child[q], tile.points[tile.successor[i]])));
        CHECK(std::hypot(again.x - to_unit_square(p).x, again.y - to_unit_square(p).y) < 1e-15);
    }

    const auto words = words_of(tile.points, rule);
    std::vector<BinaryPoint> backwards(tile.points.rbegin(), tile.points.rend());
    CHECK(words_of(backwards, rule) == words);
    const Tile again = make_tile(rule, words);
    REQUIRE(again.size() == tile.size());
    for (const BinaryPoint p : tile.points)
        CHECK(std::count(again.points.begin(), again.points.end(), p) == 1);
    CHECK(newborns_of(tile).size() == 24);
}

TEST_CASE("the half-size tile on each quadrant covers the points of the quadrant") {
    const Rule rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
    const Tile tile = make_tile(rule, {"0301213303211022"});
    for (const BinaryPoint p : tile.points) {
        const int q = quadrant_of(p);
        bool covered = false;
        for (const BinaryPoint c : tile.points) {
            const glm::dvec2 d =
                to_unit_square(shrink_to_quadrant(q, apply(rule.child[q], c))) - to_unit_square(p);
            covered = covered || std::hypot(d.x, d.y) < 1e-15;
        }
        CHECK(covered);
    }
    CHECK(newborns_of(tile).size() == 48);
}

TEST_CASE("tiles that cannot be are refused in words") {
    CHECK_THROWS_WITH(parse_tile_integers("14217;2895"),
                      "'14217;2895' is not a tile; write A,B/N, for example 14217,2895/16");
    CHECK_THROWS_WITH(parse_tile_integers("70000,1/16"),
                      "the tile 70000,1/16 is out of range; both integers must be below 65535");
    CHECK_THROWS(parse_tile_integers("1,2/15"));
    CHECK_THROWS(make_tile(Rule{}, {"01240123"}));
    CHECK_THROWS(make_tile(Rule{}, {"01230123"}));
    CHECK_THROWS(make_tile(Rule{}, {}));
    CHECK_THROWS_WITH(make_tile(Rule{}, {"0123", "0212>8"}),
                      "a tile's word leads to point 8, but the points' numbers end at 7");
    CHECK_THROWS_WITH(make_tile(Rule{}, {"012>x"}),
                      "'>x' at the end of a tile's word leads nowhere; write > and a point's number");
    CHECK_THROWS(make_tile(Rule{}, {"0123", "0123>0"}));  // the same four points again
}
