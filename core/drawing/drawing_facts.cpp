#include "core/drawing/drawing_facts.h"

#include <algorithm>

#include "core/output/gcode.h"
#include "core/output/hpgl.h"

namespace dapple {

DotsAs dots_as(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format) {
    if (is_table(format)) return DotsAs::listed;
    if (!is_plotted(format)) return DotsAs::printed;
    if (settings.style != DrawingStyle::dots) return DotsAs::lines;
    const DotShape shape = mark_in(settings, saving, format).shape;
    if (shape == DotShape::point) return DotsAs::touches;
    if (shape != DotShape::circle) return DotsAs::shapes;
    return is_touched(format) ? DotsAs::touches : DotsAs::rings;
}

InkedDot inked_dot(const DrawingSettings& settings, DrawingFormat format, const DrawingToSave& drawing) {
    InkedDot ink{.as = dots_as(settings, drawing.saving, format),
                 .radius_mm = drawing.dot_radius_mm,
                 .stroke_width_mm = settings.pen_width_mm};
    ink.widths_mm = stroke_widths(settings.pens, settings.pen_width_mm, drawing.pens,
                                  ink.as == DotsAs::touches ? PenUse::touches : PenUse::lines);
    if (ink.as == DotsAs::printed) {
        // What a pen would draw is printed as wide as its lines.
        if (settings.style != DrawingStyle::dots) ink.radius_mm = widest_stroke(settings) / 2;
        return ink;
    }
    const bool circles = !draws_strokes(settings);
    if (circles && ink.as == DotsAs::touches && settings.dot_size.sizing != DotSizing::automatic) {
        ink.stroke_width_mm = 2 * drawing.dot_radius_mm;
        if (!have_widths(settings.pens)) ink.widths_mm.clear();
    }
    return ink;
}

DrawingFacts facts_of(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format,
                      const DrawingToSave& drawing) {
    DrawingFacts facts{.dots = drawing.dots.count,
                       .ink = inked_dot(settings, format, drawing),
                       .is_svg = format == DrawingFormat::svg,
                       .has_margins = settings.page.margins.value_or(Margins{}) != Margins{},
                       .page = drawing.page};
    if (has_pixels(format)) facts.dpi = drawing.saving.dpi;
    if (format == DrawingFormat::hpgl) facts.reach_mm = kHpglReachMm;
    if (is_plotted(format)) facts.machine = saving.machine.value_or(usual_machine(format, saving.tool));
    if (format == DrawingFormat::gcode) {
        const bool built_in = saving.gcode_template.text.empty();
        const bool touches = facts.ink.as == DotsAs::touches;
        if (built_in && touches && bursts_move(saving.tool, saving.dwell_s))
            facts.burst_s = saving.dwell_s;
        else if (built_in && (touches || saving.tool == GcodeTool::servo))
            facts.dwell_s = saving.dwell_s;
    }
    // Dots of a size for the picture's tone, touched by a pen of another.
    const bool automatic = settings.dot_size.sizing == DotSizing::automatic && !draws_strokes(settings);
    if (automatic && facts.ink.as == DotsAs::touches && facts.ink.widths_mm.empty()) {
        const double times = 2 * drawing.dot_radius_mm / facts.ink.stroke_width_mm;
        facts.for_tone = {static_cast<double>(facts.dots) * times * times, drawing.dot_radius_mm};
    }
    facts.has_tile_layer = facts.is_svg && !drawing.tiles.empty();
    facts.has_background = facts.is_svg && settings.background;
    return facts;
}

}  // namespace dapple
