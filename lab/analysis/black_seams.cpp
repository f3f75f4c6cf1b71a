#include "lab/analysis/black_seams.h"

#include <vector>

namespace dapple {
namespace {

constexpr std::size_t kFewestDotsForSeams = 40'000;

}  // namespace

std::size_t full_level(const RankedTile& tile, std::size_t fewest_dots) {
    std::size_t level = tile.tile().size();
    while (level < fewest_dots) level *= 4;
    return level;
}

Seams seams_on_black(RankedTile& tile) {
    const Density black(Grid<float>(1, 1, 1.0f));
    PlacingRequest request;
    request.scale = static_cast<double>(full_level(tile, kFewestDotsForSeams)) / kDotsPerScale;
    Stippling placed;
    stipple(tile, black, PlacerKind::exact, request, placed);
    std::vector<glm::dvec2> dots;
    for_each_position(placed.dots, [&](float x, float y) { dots.emplace_back(x, y); });
    return seams(dots, kSeamLoad);
}

}  // namespace dapple
