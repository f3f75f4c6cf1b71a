#include "app/viewer/background/tile_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dapple {
namespace {

std::vector<glm::vec2> points_by_rank(const Tile& tile, const std::vector<int>& ranks) {
    std::vector<glm::vec2> points(tile.size());
    for (std::size_t i = 0; i < tile.size(); ++i) points[ranks[i]] = to_unit_square(tile.points[i]);
    return points;
}

// The upper left corner of a cell in units of its side: its index's base-4 digits are quadrants.
glm::vec2 corner_of_cell(std::size_t index, int depth) {
    glm::vec2 corner{0, 0};
    for (int level = 0; level < depth; ++level) {
        const auto weight = static_cast<float>(1 << level);
        corner.x += weight * static_cast<float>(index & 1);
        corner.y += weight * static_cast<float>((index >> 1) & 1);
        index >>= 2;
    }
    return corner;
}

// The tile's own points, then the newborn ones.
std::vector<glm::vec2> points_by_rank(const PlacingTable& table) {
    std::vector<std::pair<float, glm::vec2>> born;
    const auto side = std::ldexp(1.0f, -table.cell_depth);
    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        const glm::vec2 corner = corner_of_cell(c, table.cell_depth);
        const CellPoints& points = table.cells[c].all;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const CellPoint point = points[i];
            born.emplace_back(point.rank, (corner + glm::vec2(point.x, point.y) * 0.5f + 0.5f) * side);
        }
    }
    std::ranges::stable_sort(born, {}, &std::pair<float, glm::vec2>::first);
    std::vector<glm::vec2> points;
    for (const auto& [rank, point] : born) points.push_back(point);
    return points;
}

}  // namespace

TileView view_of(std::string name, RankedTile& tile, PlacerKind placer) {
    if (placer == PlacerKind::figure8)
        return {std::move(name), tile.tile().rule, points_by_rank(tile.tile(), tile.own_ranks())};
    std::vector<glm::vec2> points = points_by_rank(tile.placer().table());
    const auto own = points.begin() + static_cast<std::ptrdiff_t>(tile.tile().size());
    TileView view{std::move(name), tile.tile().rule, {points.begin(), own}, {}, tile.tile().next_kind};
    if (tile.tile().kinds() == 1) view.newborn.assign(own, points.end());
    return view;
}

}  // namespace dapple
