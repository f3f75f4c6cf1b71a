#include "app/viewer/view/split_comparison.h"

#include "io/files/tile_library.h"

namespace dapple {

Comparison toggled(Comparison comparison, const DrawingSettings& left) {
    comparison.on = !comparison.on;
    const std::string tile = tile_in_use(left);
    const bool alike =
        comparison.tile == tile && comparison.placer == left.placer && comparison.ranking == left.ranking;
    if (comparison.on && alike) comparison.tile = tile == "paper16" ? kDefaultTile : "paper16";
    return comparison;
}

}  // namespace dapple
