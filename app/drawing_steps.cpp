#include "app/drawing_steps.h"

namespace dapple {

std::vector<PlacedTile> tiles_of(RankedTile& tile, const Density& density, PlacerKind placer, double scale) {
    if (placer == PlacerKind::figure8)
        return place_figure8(density, tile.tile(), tile.own_ranks(), scale).tiles;
    return placed_tiles(tile.placer().table(), density, {.scale = scale});
}

}  // namespace dapple
