#include "lab/search/symmetry.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {
namespace {

double turned_back(double x) {
    const double inside = x - std::floor(x);
    return inside < 1 ? inside : 0;
}

double from_whole(double x) {
    return std::abs(x - std::round(x));
}

// The greatest number of moves within `reach` of one of them, that being no short one if `not_short`.
std::size_t most_alike(const std::vector<glm::dvec2>& moves, double reach, bool not_short) {
    const int side = std::max(1, int(1 / reach));
    const auto cell = [&](double x) { return std::min(int(x * side), side - 1); };
    std::vector<std::vector<glm::dvec2>> cells(std::size_t(side) * std::size_t(side));
    for (const glm::dvec2 move : moves)
        cells[std::size_t(cell(move.y) * side + cell(move.x))].push_back(move);
    std::size_t most = 0;
    for (const glm::dvec2 move : moves) {
        if (not_short && std::hypot(from_whole(move.x), from_whole(move.y)) <= reach) continue;
        std::size_t alike = 0;
        // Few cells are looked into once each, however near they are to the other side.
        const int around = std::min(1, (side - 1) / 2);
        for (int y = -around; y <= around; ++y) {
            for (int x = -around; x <= around; ++x) {
                const int column = (cell(move.x) + x + side) % side, row = (cell(move.y) + y + side) % side;
                for (const glm::dvec2 other : cells[std::size_t(row * side + column)])
                    if (std::hypot(from_whole(other.x - move.x), from_whole(other.y - move.y)) <= reach)
                        ++alike;
            }
        }
        most = std::max(most, alike);
    }
    return most;
}

}  // namespace

std::array<double, 8> symmetry_shares(const Tile& tile) {
    std::vector<glm::dvec2> points;
    for (const BinaryPoint p : tile.points) points.push_back(to_unit_square(p));
    const double n = double(points.size());
    std::array<double, 8> shares{};
    for (const Orientation g : all_orientations()) {
        std::vector<glm::dvec2> moves;
        for (const glm::dvec2 p : points) {
            const glm::dvec2 turned = apply(g, p - glm::dvec2(0.5)) + glm::dvec2(0.5);
            for (const glm::dvec2 q : points)
                moves.push_back({turned_back(q.x - turned.x), turned_back(q.y - turned.y)});
        }
        const std::size_t alike = most_alike(moves, kSameSymmetricPlace / std::sqrt(n), g == Orientation{});
        // Two points within reach of one count once too often; not in tiles whose points keep apart.
        shares[g.index] = std::min(1.0, double(alike) / n);
    }
    return shares;
}

double symmetry(const Tile& tile) {
    const std::array<double, 8> shares = symmetry_shares(tile);
    return std::accumulate(shares.begin(), shares.end(), 0.0) / 8;
}

}  // namespace dapple
