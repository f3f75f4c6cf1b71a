#include "app/drawing_settings.h"

namespace dapple {

std::string tile_in_use(const DrawingSettings& settings) {
    const bool turns = settings.tile == kDefaultTile && settings.placer == PlacerKind::figure8;
    return turns ? "paper16" : settings.tile;
}

bool draws_strokes(const DrawingSettings& settings) {
    return settings.style != DrawingStyle::dots || settings.mark.shape != DotShape::circle;
}

bool draws_touches(const DrawingSettings& settings) {
    return settings.style == DrawingStyle::dots && settings.mark.shape == DotShape::point;
}

double widest_stroke(const DrawingSettings& settings) {
    return draws_strokes(settings) ? settings.pen_width_mm : 0;
}

DrawingRequest request_of(const DrawingSettings& settings) {
    DotSize size = settings.dot_size;
    if (draws_touches(settings) && size.sizing != DotSizing::by_tone) {
        size.sizing = DotSizing::fixed;
        size.radius_mm = settings.pen_width_mm / 2;
    }
    return {.automatic_tone = settings.automatic_tone,
            .automatic_exposure = settings.automatic_exposure,
            .tone = settings.tone,
            .placer = settings.placer,
            .placing = settings.placing,
            .relax = settings.relax,
            .size = size,
            .joined = settings.style != DrawingStyle::dots,
            // It has no say elsewhere.
            .stroke_width_mm = keeps_dots_inside(settings.page) ? widest_stroke(settings) : 0,
            .page = settings.page};
}

}  // namespace dapple
