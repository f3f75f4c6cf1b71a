#include <array>

#include "app/viewer/panels/method_panels.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

namespace {

bool draw_right_side(Comparison& right, const TileList& tiles) {
    bool changed = tile_row("Right tile", right.tile, tiles, "The tile of the right side's dots.");
    if (choice_row("Right placer", right.placer, std::array{"exact", "Figure 8"},
                   "How the right side's dots are placed: exactly, or as printed in the article.")) {
        DrawingSettings drawing;
        drawing.tile = right.tile;
        drawing.placer = right.placer;
        right.tile = tile_in_use(drawing);
        changed = true;
    }
    const bool counted = right.placer == PlacerKind::exact;
    {
        const Absent absent(why_only_exact(right.placer));
        changed |= ranking_row("Right ranking", right.ranking);
    }
    return segmented_row("Right side has", right.by,
                         std::array{"same scale", counted ? "same count" : "similar count"},
                         "What both sides share. Figure 8 has no exact count: it gets the scale for about as "
                         "many distinct dots.") ||
           changed;
}

bool draw_split(ViewerSettings& settings, const TileList& tiles) {
    Comparison& right = settings.comparison;
    bool on = right.on, changed = false;
    if (switch_row("Split view", on,
                   "Shows another tile or placer to the right of a line that you can drag.")) {
        right = toggled(right, settings.drawing);
        changed = true;
    }
    {
        const Absent absent(right.on ? nullptr : "Applies to the split view only.");
        changed |= draw_right_side(right, tiles);
    }
    hint("Repetition shows best on an even grey or a ramp: Density, above.");
    return changed;
}

bool draw_loupe(LoupeChoice& loupe) {
    bool changed = switch_row("Loupe", loupe.on, "A lens that overlays the tiles: what repeats stays crisp.");
    const Absent absent(loupe.on ? nullptr : "Applies to the loupe only.");
    const char* const words = loupe.step == 0 ? "fitting" : loupe.step > 0 ? "smaller" : "larger";
    changed |= slider_row("Its tiles", loupe.step,
                          {.min = -3,
                           .max = 3,
                           .format = words,
                           .tip = "Size of the overlaid tiles; a step to the right halves their side."});
    return changed;
}

}  // namespace

bool draw_compare_panel(ViewerSettings& settings, const TileList& tiles) {
    if (!subsection("Compare")) return false;
    const bool changed = draw_split(settings, tiles);
    return draw_loupe(settings.loupe) || changed;
}

}  // namespace dapple
