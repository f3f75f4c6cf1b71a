#include "app/viewer/panels/view_panel.h"

#include <array>

#include "app/viewer/widgets/widgets.h"

namespace dapple {

bool draw_view_panel(ViewerSettings& settings) {
    if (!section("View")) return false;
    bool changed = slider_row(
        "Photograph", settings.picture_opacity,
        {.min = 0,
         .max = 1,
         .neutral = 0,
         .tip = "How much of the photograph shows through under the dots; holding P shows all of it."});
    changed |= switch_row("Tile boundaries", settings.drawing.show_tiles,
                          "Draws the square of each copy of the tile; an exported SVG has them as a layer.");
    int colouring = static_cast<int>(settings.colouring);
    if (choice_row("Dots coloured", colouring,
                   std::array{"in ink", "by level", "by rank", "by tile orientation"},
                   "by level: how often the page was divided. by rank: how early in its tile. by tile "
                   "orientation: how "
                   "its tile is turned.")) {
        settings.colouring = static_cast<DotColouring>(colouring);
        changed = true;
    }
    const Greyed greyed(
        settings.drawing.placer == PlacerKind::exact ? nullptr : "Figure 8 places whole drawings only.");
    int mode = static_cast<int>(settings.zoom_mode);
    if (segmented_row("Zooming in", mode, std::array{"larger dots", "more dots"},
                      "larger dots: as on paper under a lens. more dots: they keep their size, and new ones "
                      "appear between "
                      "them without end.")) {
        settings.zoom_mode = static_cast<ZoomMode>(mode);
        changed = true;
    }
    return changed;
}

}  // namespace dapple
