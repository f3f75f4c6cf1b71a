#include "core/drawing/settings.h"

namespace dapple {

std::string tile_in_use(const DrawingSettings& settings) {
    if (settings.tile != kDefaultTile) return settings.tile;
    if (settings.placer == PlacerKind::figure8) return "paper16";
    const bool one_by_one = settings.ranking.value_or(RankingMethod::energy) != RankingMethod::energy;
    return one_by_one ? "aperiodic4096" : settings.tile;
}

}  // namespace dapple
