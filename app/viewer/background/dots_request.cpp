#include "app/viewer/background/dots_request.h"

namespace dapple {

DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density) {
    return {.drawing = settings,
            .tile = tile_in_use(settings),
            .ranking = settings.ranking,
            .outlines = settings.show_tiles,
            .density = density,
            .strokes = {settings.style, settings.mark, settings.pen_width_mm, {}, settings.pens}};
}

}  // namespace dapple
