#include "app/viewer/panels/view_panel.h"

#include <array>
#include <cmath>

#include "app/viewer/widgets/widgets.h"

namespace dapple {

namespace {

bool draw_density(DensityChoice& density) {
    int source = static_cast<int>(density.source);
    const bool chosen = segmented_row("Density", source, std::array{"photo", "grey", "ramp"});
    density.source = static_cast<DensitySource>(source);
    if (density.source != DensitySource::grey) return chosen;
    return slider_row("Grey", density.grey,
                      {.min = 0.01, .max = 1, .neutral = 0.5, .hard_min = 0, .hard_max = 1}) ||
           chosen;
}

}  // namespace

bool draw_view_panel(ViewerSettings& settings) {
    if (!section("View")) return false;
    bool changed = draw_density(settings.density);
    changed |= slider_row("Photograph", settings.picture_opacity, {.min = 0, .max = 1, .neutral = 0});
    changed |= switch_row("Tile boundaries", settings.drawing.show_tiles);
    // Figure 8 places whole drawings only.
    if (settings.drawing.placer == PlacerKind::exact) {
        int mode = static_cast<int>(settings.zoom_mode);
        if (segmented_row("Zooming in", mode, std::array{"larger dots", "more dots"})) {
            settings.zoom_mode = static_cast<ZoomMode>(mode);
            changed = true;
        }
    }
    int colouring = static_cast<int>(settings.colouring);
    if (choice_row("Dots coloured", colouring,
                   std::array{"in ink", "by level", "by rank", "by tile orientation"})) {
        settings.colouring = static_cast<DotColouring>(colouring);
        changed = true;
    }
    double deepest = settings.deepest_level;
    if (slider_row("Levels up to", deepest,
                   {.min = 0,
                    .max = kDeepestStep,
                    .neutral = kDeepestStep,
                    .format = settings.deepest_level == kDeepestStep ? "all" : "%.0f"})) {
        changed |= settings.deepest_level != static_cast<int>(std::lround(deepest));
        settings.deepest_level = static_cast<int>(std::lround(deepest));
    }
    changed |= colour_row("Ink", settings.drawing.ink);
    changed |= colour_row("Paper", settings.drawing.paper);
    changed |= switch_row("Every frame", settings.every_frame);
    return changed;
}

}  // namespace dapple
