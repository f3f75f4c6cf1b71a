#include "app/drawing_settings.h"

namespace dapple {

std::string tile_in_use(const DrawingSettings& settings) {
    const bool turns = settings.tile == kDefaultTile && settings.placer == PlacerKind::figure8;
    return turns ? "paper16" : settings.tile;
}

DrawingRequest request_of(const DrawingSettings& settings) {
    return {.automatic_tone = settings.automatic_tone,
            .automatic_exposure = settings.automatic_exposure,
            .tone = settings.tone,
            .placer = settings.placer,
            .placing = settings.placing,
            .relax = settings.relax,
            .size = settings.dot_size,
            .page = settings.page};
}

}  // namespace dapple
