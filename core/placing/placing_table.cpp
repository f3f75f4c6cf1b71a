#include "core/placing/placing_table.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dapple {

namespace {

// The cell of a point, and the point within it about its centre, in half sides.
struct InCell {
    std::size_t cell;
    glm::dvec2 offset;
};

InCell find_cell(BinaryPoint p, int depth) {
    std::size_t cell = 0;
    for (int i = 0; i < depth; ++i) {
        cell = cell * 4 + quadrant_of(p);
        p = enlarge_quadrant(p);
    }
    return {cell, 2.0 * to_unit_square(p) - 1.0};
}

PointBlock empty_block() {
    PointBlock block{};
    std::ranges::fill(block.birth, std::numeric_limits<float>::infinity());
    return block;
}

CellPoints by_birth(std::vector<CellPoint> points) {
    std::ranges::stable_sort(points, {}, &CellPoint::birth);
    CellPoints sorted;
    for (const CellPoint& point : points) sorted.add(point);
    return sorted;
}

// Each cell's points, of these tile points and births.
std::vector<std::vector<CellPoint>> share_out(const PlacingTable& table, const auto& position_of,
                                              const std::vector<float>& births) {
    std::vector<std::vector<CellPoint>> points(table.cells.size());
    for (std::size_t i = 0; i < births.size(); ++i) {
        const InCell in = find_cell(position_of(i), table.cell_depth);
        points[in.cell].push_back(
            {static_cast<float>(in.offset.x), static_cast<float>(in.offset.y), births[i]});
    }
    return points;
}

}  // namespace

void CellPoints::clear() {
    blocks_.assign(1, empty_block());
    size_ = 0;
}

void CellPoints::add(const CellPoint& point) {
    const std::size_t i = size_ % kBlockPoints;
    if (i == 0) blocks_.push_back(empty_block());
    PointBlock& block = blocks_[size_++ / kBlockPoints];
    block.at[0][i] = point.x;
    block.at[1][i] = point.y;
    block.birth[i] = point.birth;
}

CellPoint CellPoints::operator[](std::size_t i) const {
    const PointBlock& block = blocks_[i / kBlockPoints];
    return {block.at[0][i % kBlockPoints], block.at[1][i % kBlockPoints], block.birth[i % kBlockPoints]};
}

PlacingTable make_placing_table(const Tile& tile, const Ranking& ranking) {
    PlacingTable table;
    table.tile_size = tile.size();
    table.rule = tile.rule;
    for (std::size_t points = tile.size(); points >= 64; points /= 4) ++table.cell_depth;
    table.cells.resize(std::size_t{1} << (2 * table.cell_depth));

    const std::vector<Newborn> newborns = newborns_of(tile);
    const auto own = share_out(
        table, [&](std::size_t i) { return tile.points[i]; }, ranking.tile);
    const auto newborn = share_out(
        table, [&](std::size_t i) { return newborns[i].position; }, ranking.newborn);

    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        Cell& cell = table.cells[c];
        cell.newborn = by_birth(newborn[c]);
        std::vector<CellPoint> all = own[c];
        all.insert(all.end(), newborn[c].begin(), newborn[c].end());
        cell.all = by_birth(std::move(all));
        // A quadrant of a cell is a cell of the child tile in the cell's outermost quadrant: drop the first
        // digit, append the quadrant, and see the digits from the child's frame.
        for (int q = 0; q < 4; ++q) {
            const std::size_t digits = c * 4 + q;
            const int child = static_cast<int>(digits >> (2 * table.cell_depth));
            const Orientation turn = tile.rule.child[child];
            std::size_t next = 0;
            for (int d = table.cell_depth - 1; d >= 0; --d) {
                next = next * 4 + apply_to_quadrant(inverse(turn), static_cast<int>(digits >> (2 * d) & 3));
            }
            cell.next_cell[q] = static_cast<std::uint16_t>(next);
            cell.next_turn[q] = turn;
        }
    }
    for (Cell& cell : table.cells) {
        for (std::size_t q = 0; q < 4; ++q) {
            // Its own newborn points come before those of its quadrants, if it has any.
            const float last = 4 * static_cast<float>(tile.size());
            cell.next_birth[q] = std::min(table.cells[cell.next_cell[q]].newborn[0].birth, last);
        }
        cell.first_next_birth = *std::ranges::min_element(cell.next_birth);
    }
    return table;
}

}  // namespace dapple
