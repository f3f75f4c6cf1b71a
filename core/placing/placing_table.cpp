#include "core/placing/placing_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace dapple {

namespace {

constexpr std::size_t kMostOwnPoints = 64;  // of a cell; it has three times as many newborn ones
constexpr std::size_t kMostSubtreePoints = 1536;

// The cell of a point in its kind, and the point within it about its centre, in half sides.
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
    std::ranges::fill(block.rank, std::numeric_limits<float>::infinity());
    return block;
}

using PointsOfCells = std::vector<std::vector<CellPoint>>;

void sort_by_rank(PointsOfCells& cells) {
    for (std::vector<CellPoint>& points : cells) std::ranges::stable_sort(points, {}, &CellPoint::rank);
}

// Rounded to a grid so coarse that single precision holds the point in the frame of a subtree too: it comes
// to the same place to the bit, with whatever square it comes. Not onto the cell's edge, which is its
// neighbour's.
float on_grid(double offset) {
    constexpr double kStep = 0x1p-21, kLast = 1 - kStep;
    return static_cast<float>(std::clamp(std::round(offset / kStep) * kStep, -kLast, kLast));
}

// Each cell's points, of these tile points, so many of each kind, and ranks.
PointsOfCells share_out(const PlacingTable& table, const auto& position_of, std::size_t of_each_kind,
                        const std::vector<float>& ranks) {
    PointsOfCells points(table.cells.size());
    const std::size_t cells = table.cells.size() / table.next_kind.size();
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        const InCell in = find_cell(position_of(i), table.cell_depth);
        points[i / of_each_kind * cells + in.cell].push_back(
            {on_grid(in.offset.x), on_grid(in.offset.y), ranks[i]});
    }
    return points;
}

// How many generations of newborn points below a cell's own its subtree takes in.
int generations_below(std::size_t cell_points) {
    int generations = 0;
    std::size_t newborn = 3 * cell_points, all = newborn;
    while (all + 4 * newborn <= kMostSubtreePoints) {
        ++generations;
        newborn *= 4;
        all += newborn;
    }
    return generations;
}

// The newborn points of a square and of those `generations` down, in the frame and the ranks of a cell above.
struct Subtree {
    const PlacingTable& table;
    const PointsOfCells& newborn;
    std::vector<CellPoint>& points;

    void add(std::size_t index, Orientation turn, glm::dvec2 centre, double half, int generations) {
        const Cell& cell = table.cells[index];
        const SwapAndSigns steps = steps_of(turn);
        for (CellPoint point : newborn[index]) {
            if (steps.swap) std::swap(point.x, point.y);
            const glm::dvec2 offset(steps.negate_x ? -point.x : point.x, steps.negate_y ? -point.y : point.y);
            const glm::dvec2 position = centre + half * offset;
            points.push_back({static_cast<float>(position.x), static_cast<float>(position.y),
                              static_cast<float>(point.rank / (half * half))});
        }
        if (generations == 0) return;
        for (int q = 0; q < 4; ++q) {
            const int placed = apply_to_quadrant(turn, q);
            const glm::dvec2 corner(placed & 1, placed >> 1);
            add(cell.next_cell[q], compose(turn, cell.next_turn[q]), centre + half * (corner - 0.5), half / 2,
                generations - 1);
        }
    }
};

// The lowest rank below the subtree of so many generations, in the cell's ranks.
float end_of_subtree(const PlacingTable& table, const Cell& cell, int generations) {
    if (generations == 0) return 4 * cell.first_next_rank;
    float end = std::numeric_limits<float>::infinity();
    for (const std::uint16_t next : cell.next_cell)
        end = std::min(end, 4 * end_of_subtree(table, table.cells[next], generations - 1));
    return end;
}

}  // namespace

CellPoint CellPoints::operator[](std::size_t i) const {
    const PointBlock& block = blocks_[i / kBlockPoints];
    return {block.at[0][i % kBlockPoints], block.at[1][i % kBlockPoints], block.rank[i % kBlockPoints]};
}

PointLists::PointLists(const std::vector<std::vector<CellPoint>>& lists) {
    const auto blocks_of = [](const auto& points) {
        return (points.size() + kBlockPoints - 1) / kBlockPoints + 1;
    };
    std::size_t blocks = 0;
    for (const auto& points : lists) blocks += blocks_of(points);
    blocks_.resize(blocks, empty_block());
    block_ends_.resize(blocks);
    std::size_t first = 0;
    for (const auto& points : lists) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            PointBlock& block = blocks_[first + i / kBlockPoints];
            block.at[0][i % kBlockPoints] = points[i].x;
            block.at[1][i % kBlockPoints] = points[i].y;
            block.rank[i % kBlockPoints] = points[i].rank;
        }
        CellPoints& list = lists_.emplace_back();
        list.size_ = points.size();
        if (!points.empty()) list.last_rank_ = points.back().rank;
        list.blocks_ = &blocks_[first];
        list.block_ends_ = &block_ends_[first];
        first += blocks_of(points);
    }
    for (std::size_t b = 0; b < blocks; ++b) block_ends_[b] = blocks_[b].rank[kBlockPoints - 1];
}

PlacingTable make_placing_table(const Tile& tile, const Ranking& ranking) {
    PlacingTable table;
    table.tile_size = tile.size();
    table.rule = tile.rule;
    table.next_kind = tile.next_kind;
    std::size_t cell_points = tile.size();
    for (; cell_points > kMostOwnPoints; cell_points /= 4) ++table.cell_depth;
    const std::size_t cells = std::size_t{1} << (2 * table.cell_depth);  // of a kind
    table.cells.resize(cells * tile.kinds());

    const std::vector<Newborn> newborns = newborns_of(tile);
    PointsOfCells all = share_out(
        table, [&](std::size_t i) { return tile.points[i]; }, tile.size(), ranking.tile);
    PointsOfCells newborn = share_out(
        table, [&](std::size_t i) { return newborns[i].position; }, 3 * tile.size(), ranking.newborn);
    for (std::size_t c = 0; c < cells; ++c) all[c].insert(all[c].end(), newborn[c].begin(), newborn[c].end());
    sort_by_rank(all);
    sort_by_rank(newborn);

    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        Cell& cell = table.cells[c];
        // A quadrant of a cell is a cell of the child tile in the cell's outermost quadrant: drop the first
        // digit, append the quadrant, and see the digits from the child's frame.
        for (int q = 0; q < 4; ++q) {
            const std::size_t digits = c % cells * 4 + static_cast<std::size_t>(q);
            const int child = static_cast<int>(digits >> (2 * table.cell_depth));
            const Orientation turn = tile.rule.child[child];
            std::size_t next = 0;
            for (int d = table.cell_depth - 1; d >= 0; --d) {
                next = next * 4 + apply_to_quadrant(inverse(turn), static_cast<int>(digits >> (2 * d) & 3));
            }
            const std::size_t kind = tile.next_kind[c / cells][static_cast<std::size_t>(child)];
            cell.next_cell[q] = static_cast<std::uint16_t>(kind * cells + next);
            cell.next_turn[q] = turn;
        }
    }
    for (Cell& cell : table.cells) {
        for (std::size_t q = 0; q < 4; ++q) {
            // Its own newborn points come before those of its quadrants, if it has any.
            const float last = 4 * static_cast<float>(tile.size());
            const auto& born = newborn[cell.next_cell[q]];
            cell.next_rank[q] = born.empty() ? last : std::min(born[0].rank, last);
        }
        cell.first_next_rank = *std::ranges::min_element(cell.next_rank);
    }
    const int generations = generations_below(cell_points);
    PointsOfCells subtree(table.cells.size());
    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        Subtree{table, newborn, subtree[c]}.add(c, {}, {0, 0}, 1, generations);
        table.cells[c].subtree_end = end_of_subtree(table, table.cells[c], generations);
    }
    sort_by_rank(subtree);

    PointsOfCells lists;
    for (PointsOfCells* of_cells : {&subtree, &newborn, &all})
        std::ranges::move(*of_cells, std::back_inserter(lists));
    table.points = PointLists(lists);
    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        Cell& cell = table.cells[c];
        cell.subtree = table.points[c];
        cell.newborn = table.points[table.cells.size() + c];
        cell.all = table.points[2 * table.cells.size() + c];
    }
    return table;
}

}  // namespace dapple
