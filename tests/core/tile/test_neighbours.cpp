#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "core/tile/tile.h"

using namespace dapple;

namespace {

const Rule kAperiodic{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};

// A subdivision carried out in full: the orientation of every tile of a level.
std::vector<std::vector<Orientation>> subdivided(const Rule& rule, int levels) {
    std::vector<std::vector<Orientation>> tiles{{Orientation{}}};
    for (int level = 0; level < levels; ++level) {
        const std::size_t n = tiles.size();
        std::vector<std::vector<Orientation>> next(2 * n, std::vector<Orientation>(2 * n));
        for (std::size_t y = 0; y < n; ++y) {
            for (std::size_t x = 0; x < n; ++x) {
                for (int q = 0; q < 4; ++q) {
                    const int placed = apply_to_quadrant(tiles[y][x], q);
                    next[2 * y + (placed >> 1)][2 * x + (placed & 1)] = compose(tiles[y][x], rule.child[q]);
                }
            }
        }
        tiles = next;
    }
    return tiles;
}

}  // namespace

TEST_CASE("the paper's tile has the eight neighbours of the torus") {
    const auto neighbours = legal_neighbours(Rule{});
    CHECK(neighbours.size() == 8);
    for (const Neighbour& n : neighbours) {
        CHECK(n.orientation == Orientation{});
        CHECK(n.probability == doctest::Approx(1));
    }
}

TEST_CASE("legal neighbours are those that a real subdivision shows, as often as they do") {
    const auto neighbours = legal_neighbours(kAperiodic);
    const auto tiles = subdivided(kAperiodic, 9);
    const int n = static_cast<int>(tiles.size());
    std::map<std::array<int, 3>, int> seen;
    for (int y = 1; y + 1 < n; ++y) {
        for (int x = 1; x + 1 < n; ++x) {
            const Orientation frame = inverse(tiles[y][x]);
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (dx == 0 && dy == 0) continue;
                    const glm::dvec2 offset = apply(frame, glm::dvec2(dx, dy));
                    const Orientation other = compose(frame, tiles[y + dy][x + dx]);
                    ++seen[{static_cast<int>(offset.x), static_cast<int>(offset.y), other.index}];
                }
            }
        }
    }
    CHECK(seen.size() == neighbours.size());
    CHECK(neighbours.size() > 50);
    const double tile_count = (n - 2.0) * (n - 2.0);
    for (const Neighbour& neighbour : neighbours) {
        const auto found = seen.find({neighbour.offset.x, neighbour.offset.y, neighbour.orientation.index});
        REQUIRE(found != seen.end());
        CHECK(found->second / tile_count == doctest::Approx(neighbour.probability).epsilon(0.1));
    }
}
