#include "core/tile/neighbours.h"

#include <array>

namespace dapple {

namespace {

// Occurrence of each relative orientation at each offset; the centre holds the tile itself.
using Table = std::array<std::array<std::array<double, 8>, 3>, 3>;

constexpr int kSettlingRounds =
    200;  // far beyond the few rounds in which the chance of each neighbour settles

glm::ivec2 turn(Orientation g, glm::ivec2 v) {
    return glm::ivec2(apply(g, glm::dvec2(v)));
}

// Where the child in quadrant q lies in a tile with the given orientation, as 0 or 1 on each axis.
glm::ivec2 child_cell(Orientation g, int q) {
    const int placed = apply_to_quadrant(g, q);
    return {placed & 1, placed >> 1};
}

// One subdivision: from the neighbours that tiles have to those that their children have.
Table subdivide(const Rule& rule, const Table& parents) {
    Table children{};
    for (int ox = -1; ox <= 1; ++ox) {
        for (int oy = -1; oy <= 1; ++oy) {
            for (const Orientation other : all_orientations()) {
                const double weight = parents[ox + 1][oy + 1][other.index];
                if (weight == 0) continue;
                for (int q = 0; q < 4; ++q) {
                    const Orientation frame = inverse(rule.child[q]);
                    for (int r = 0; r < 4; ++r) {
                        const glm::ivec2 between =
                            2 * glm::ivec2(ox, oy) + child_cell(other, r) - child_cell(Orientation{}, q);
                        if (between.x * between.x > 1 || between.y * between.y > 1) continue;
                        const glm::ivec2 offset = turn(frame, between);
                        const Orientation seen = compose(frame, compose(other, rule.child[r]));
                        children[offset.x + 1][offset.y + 1][seen.index] += weight / 4;
                    }
                }
            }
        }
    }
    return children;
}

}  // namespace

std::vector<Neighbour> legal_neighbours(const Rule& rule) {
    Table table{};
    table[1][1][0] = 1;  // a lone tile
    Table occurred{};
    Table settled{};
    for (int round = 0; round < kSettlingRounds; ++round) {
        table = subdivide(rule, table);
        for (int x = 0; x < 3; ++x) {
            for (int y = 0; y < 3; ++y) {
                for (int g = 0; g < 8; ++g) {
                    occurred[x][y][g] += table[x][y][g];
                    // The chances may alternate from level to level: average over the later half.
                    if (round >= kSettlingRounds / 2) settled[x][y][g] += table[x][y][g];
                }
            }
        }
    }

    std::vector<Neighbour> neighbours;
    for (int x = 0; x < 3; ++x) {
        for (int y = 0; y < 3; ++y) {
            if (x == 1 && y == 1) continue;
            double sum = 0;
            for (const double p : settled[x][y]) sum += p;
            for (const Orientation g : all_orientations()) {
                if (occurred[x][y][g.index] == 0) continue;
                neighbours.push_back({{x - 1, y - 1}, g, settled[x][y][g.index] / sum});
            }
        }
    }
    return neighbours;
}

glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p) {
    return glm::dvec2(neighbour.offset) + apply(neighbour.orientation, p - 0.5) + 0.5;
}

}  // namespace dapple
