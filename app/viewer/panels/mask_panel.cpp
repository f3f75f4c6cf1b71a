#include "app/viewer/panels/settings_panels.h"

#include <array>

#include "app/viewer/widgets/widgets.h"

namespace dapple {
bool draw_mask_panel(DrawingSettings& drawing, MaskBrush& tool) {
    if (!section("Mask")) {
        tool.on = false;  // what cannot be seen is not to paint
        return false;
    }
    Brush& brush = tool.brush;
    int paints = tool.on ? 1 + static_cast<int>(brush.kind) : 0;
    if (segmented_row(
            "Brush", paints, std::array{"off", "more", "fewer", "none", "finer", "erase"},
            "Paint with the left mouse button; the middle one moves the page. more: up to four times as many "
            "dots, where the tone leaves room. fewer: half as many. none: bare paper. finer: up to four "
            "times as many dots of half the width, at the same tone. erase: removes paint.")) {
        tool.on = paints > 0;
        if (tool.on) brush.kind = static_cast<BrushKind>(paints - 1);
    }
    const bool paints_finer = tool.on && brush.kind == BrushKind::finer;
    if ((paints_finer || drawing.mask.has_finer()) && !can_be_finer(drawing)) {
        hint("Lines and dots as wide as their pen cannot be finer.");
        note_place("Not finer");
    }
    double percent = 100 * brush.radius;
    if (slider_row("Size, %", percent,
                   {.min = 0.5,
                    .max = 50,
                    .neutral = 5,
                    .curve = SliderCurve::logarithmic,
                    .format = "%.1f",
                    .hard_min = 100 * kSmallestBrush,
                    .hard_max = 100 * kLargestBrush,
                    .tip = "Brush radius, in percent of the picture's longer side. Keys: [ and ], or Ctrl "
                           "and the wheel."}))
        brush.radius = percent / 100;
    slider_row("Softness", brush.softness,
               {.neutral = 0.5, .tip = "How much of the brush fades towards its rim; 0 is a sharp edge."});
    slider_row("Strength", brush.strength,
               {.min = 0.05,
                .neutral = 1,
                .hard_min = 0.01,
                .tip = "Strength of one stroke; further strokes add to it."});
    const Absent absent(drawing.mask.empty() ? "Nothing is masked." : nullptr);
    const bool cleared = wide_button("Clear the mask", "Removes all paint.");
    if (cleared) drawing.mask = {};
    return cleared;
}

bool draw_retouch_panel(DrawingSettings& drawing, RetouchTool& tool) {
    if (!section("Retouch")) return false;
    segmented_row("Tool", tool.hand, names_of(tool.hand),
                  "With the left mouse button: removes a dot, adds one, moves it or, dragged away from its "
                  "middle, enlarges it; whitens with a brush; or draws a lasso around dots to remove. Edits "
                  "stay with any number of dots, and no other dot moves.");
    slider_row("Whitener, mm", tool.brush_mm,
               {.min = 0.2,
                .max = 50,
                .neutral = 2,
                .curve = SliderCurve::logarithmic,
                .hard_min = 0.05,
                .hard_max = 500,
                .tip = "Radius of the whitening brush, on paper."});
    const Absent absent(drawing.edits.empty() ? "Nothing is retouched." : nullptr);
    if (wide_button("Undo all retouching", "Puts all dots back where tile and tone have them."))
        drawing.edits.clear();
    return true;
}

}  // namespace dapple
