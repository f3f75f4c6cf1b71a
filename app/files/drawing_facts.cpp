#include "app/files/drawing_facts.h"

namespace dapple {

DotsAs dots_as(DrawingFormat format) {
    if (is_table(format)) return DotsAs::listed;
    if (!is_plotted(format)) return DotsAs::printed;
    const bool touched = format == DrawingFormat::gcode || format == DrawingFormat::hpgl;
    return touched ? DotsAs::touches : DotsAs::rings;
}

InkedDot inked_dot(DrawingFormat format, const DrawingToSave& drawing) {
    return {.as = dots_as(format), .radius_mm = drawing.dot_radius_mm};
}

DrawingFacts facts_of(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format,
                      const DrawingToSave& drawing) {
    DrawingFacts facts{.dots = drawing.dots.count,
                       .ink = inked_dot(format, drawing),
                       .is_svg = format == DrawingFormat::svg,
                       .has_margins = settings.page.margins != Margins{},
                       .page = drawing.page};
    if (has_pixels(format)) facts.dpi = drawing.dpi;
    if (is_plotted(format)) facts.machine = saving.machine.value_or(usual_machine(format, saving.tool));
    if (facts.is_svg && !drawing.tiles.empty()) facts.tile_layer = 2;
    return facts;
}

}  // namespace dapple
