#include "core/placing/placing_table.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/placing/kernel.h"

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

void add(CellPoints& points, glm::dvec2 offset, float birth) {
    points.x.push_back(static_cast<float>(offset.x));
    points.y.push_back(static_cast<float>(offset.y));
    points.birth.push_back(birth);
}

CellPoints sorted_and_padded(const CellPoints& points) {
    std::vector<std::size_t> order(points.birth.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points.birth[a] < points.birth[b]; });
    CellPoints sorted;
    for (const std::size_t i : order) add(sorted, {points.x[i], points.y[i]}, points.birth[i]);
    sorted.count = order.size();
    pad(sorted);
    return sorted;
}

}  // namespace

void pad(CellPoints& points) {
    // A kernel that starts on the last point reads to the end of its lanes, and then looks one further.
    const std::size_t padded = (points.count / kKernelPadding + 2) * kKernelPadding;
    points.x.resize(padded, 0.0f);
    points.y.resize(padded, 0.0f);
    points.birth.resize(padded, std::numeric_limits<float>::infinity());
}

PlacingTable make_placing_table(const Tile& tile, const Ranking& ranking) {
    PlacingTable table;
    table.tile_size = tile.size();
    table.rule = tile.rule;
    for (std::size_t points = tile.size(); points >= 64; points /= 4) ++table.cell_depth;
    table.cells.resize(std::size_t{1} << (2 * table.cell_depth));

    for (std::size_t i = 0; i < tile.size(); ++i) {
        const InCell in = find_cell(tile.points[i], table.cell_depth);
        add(table.cells[in.cell].own, in.offset, ranking.tile[i]);
    }
    const std::vector<Newborn> newborns = newborns_of(tile);
    for (std::size_t i = 0; i < newborns.size(); ++i) {
        const InCell in = find_cell(newborns[i].position, table.cell_depth);
        add(table.cells[in.cell].newborn, in.offset, ranking.newborn[i]);
    }

    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        Cell& cell = table.cells[c];
        cell.own = sorted_and_padded(cell.own);
        cell.newborn = sorted_and_padded(cell.newborn);
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
    return table;
}

}  // namespace dapple
