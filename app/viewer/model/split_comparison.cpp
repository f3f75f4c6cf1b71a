#include "app/viewer/model/split_comparison.h"

#include <algorithm>
#include <cmath>

#include "app/files/tile_library.h"

namespace dapple {

Comparison toggled(Comparison comparison, const DrawingSettings& left) {
    comparison.on = !comparison.on;
    const std::string tile = tile_in_use(left);
    const bool alike =
        comparison.tile == tile && comparison.placer == left.placer && comparison.ranking == left.ranking;
    if (comparison.on && alike) comparison.tile = tile == "paper16" ? kDefaultTile : "paper16";
    return comparison;
}

DotsRequest right_request(const Comparison& comparison, DotsRequest left, const Stippling& placed) {
    DotsRequest right = std::move(left);
    right.drawing.placer = comparison.placer;
    right.tile = comparison.tile;
    right.ranking = comparison.ranking;
    right.close.reset();
    right.drawing.placing.count.reset();
    if (comparison.by == CompareBy::count)
        right.drawing.placing.count = std::max<std::uint64_t>(placed.dots.size() - placed.duplicates, 1);
    // A drawing of exactly so many dots ends just on its scale; the last of them lies within the next.
    right.drawing.placing.scale = std::nextafter(static_cast<float>(placed.scale), INFINITY);
    return right;
}

std::string drawn_with(const DotsRequest& request) {
    return short_tile_name(request.tile) +
           (request.drawing.placer == PlacerKind::figure8 ? ", Figure 8" : "");
}

}  // namespace dapple
