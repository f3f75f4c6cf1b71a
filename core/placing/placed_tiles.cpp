#include <cmath>

#include "core/placing/placer.h"
#include "core/placing/traversal.h"

namespace dapple {

namespace {

// A tile of a level is a square `cell_depth` above the cells that make it up; its own orientation and kind
// are found on the way.
void collect(const Traversal& traversal, const QuadSquare& square, Orientation orientation, std::size_t kind,
             std::vector<PlacedTile>& tiles) {
    const PlacingTable& table = traversal.table();
    if (!overlap(traversal.window(), traversal.area_of(square))) return;
    const double ranks = std::ldexp(kDotsPerScale * traversal.request().scale, -2 * square.depth);
    const double max = traversal.density().bounds(square).max;
    if (ranks * max <= (square.depth == 0 ? 0.0 : static_cast<double>(table.tile_size))) return;
    const glm::dvec2 corner = traversal.corner_in_window(square);
    tiles.push_back({square.depth, corner.x, corner.y, std::ldexp(1.0, -square.depth), orientation});
    if (table.next_kind.size() > 1) tiles.back().kind = kind;
    // Its children appear with the first of their newborn points.
    if (ranks * max <= static_cast<double>(table.tile_size) || square.depth >= kMaxDepth) return;
    for (int q = 0; q < 4; ++q) {
        const int placed = apply_to_quadrant(orientation, q);
        collect(traversal, {square.depth + 1, 2 * square.x + (placed & 1), 2 * square.y + (placed >> 1)},
                compose(orientation, table.rule.child[q]), table.next_kind[kind][q], tiles);
    }
}

}  // namespace

std::vector<PlacedTile> placed_tiles(const PlacingTable& table, const Density& density,
                                     const PlacingRequest& request) {
    const Traversal traversal(table, density, request);
    std::vector<PlacedTile> tiles;
    for (int root = 0; root < 4; ++root)
        collect(traversal, {0, (root & 1) - 1, (root >> 1) - 1}, {}, 0, tiles);
    return tiles;
}

}  // namespace dapple
