#include "app/viewer/model/drawing_file.h"

#include "app/files/gcode_choice.h"
#include "app/settings/embedded_settings.h"
#include "app/viewer/model/drawn_sheet.h"

namespace dapple {

bool needs_thresholds(const DrawingFile& file) {
    const DrawingFormat format = drawing_format(file.path);
    return is_table(format) || (!has_pixels(format) && file.saving.order == DotOrder::priority);
}

bool save_placed(const DrawingFile& file, PlacedDrawing& drawing, const SavingWatch& watch) {
    const DrawingFormat format = drawing_format(file.path);
    const DrawingStyle style = file.settings.style;
    const DrawnSheet seen = see_sheet(drawing);
    DrawingToSave to_save{
        .dots = stream_of(drawing.stippling.dots, drawing.stippling.scale),
        .page = seen.page,
        .pens = drawing.pens,
        .dot_radius_mm = drawing.dot_radius * seen.page.mm_per_page_unit,
        .tiles = drawing.outlines,
        .picture = seen.picture,
        .tile_size = file.tile_size,
        .dpi = file.saving.dpi,
        .bits = file.saving.bits,
        .order = has_order(format, style) ? file.saving.order : std::optional(DotOrder::recursion),
        .settings = embedded_settings(file.path, file.settings, file.saving)};
    if (format == DrawingFormat::gcode) to_save.gcode = gcode_style_of(file.saving);
    return save_drawing(file.path, file.settings, to_save, watch);
}

}  // namespace dapple
