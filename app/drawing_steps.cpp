#include "app/drawing_steps.h"

namespace dapple {

std::vector<PlacedTile> tiles_of(RankedTile& tile, const Density& density, PlacerKind placer, double scale) {
    if (placer == PlacerKind::figure8)
        return place_figure8(density, tile.tile(), tile.own_ranks(), scale).tiles;
    return placed_tiles(tile.placer().table(), density, {.scale = scale});
}

void fill_critical_scales(Dots& dots, const Density& density) {
    if (dots.critical.size() == dots.size()) return;
    dots.critical.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i)
        dots.critical[i] = static_cast<float>(dots.threshold[i] / density.at({dots.x[i], dots.y[i]}));
}

}  // namespace dapple
