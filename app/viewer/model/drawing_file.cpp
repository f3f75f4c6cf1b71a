#include "app/viewer/model/drawing_file.h"

#include "app/files/sheet_files.h"
#include "app/settings/embedded_settings.h"
#include "app/viewer/model/drawn_sheet.h"

namespace dapple {

namespace fs = std::filesystem;

namespace {

SheetDots dots_for(DrawingFormat format, DrawingStyle style) {
    if (style != DrawingStyle::dots && !is_table(format)) return SheetDots::of_the_page;
    // What is seen shows the part of a dot that reaches over from the next sheet.
    return has_colours(format) ? SheetDots::reaching : SheetDots::own;
}

bool save_sheet(const DrawingFile& file, const fs::path& path, const Sheet& sheet, PlacedDrawing& drawing,
                const SavingWatch& watch) {
    const DrawingFormat format = drawing_format(path);
    const DrawingStyle style = file.settings.style;
    const std::vector<CutMark> marks = cut_marks(drawing.layout.page, sheet);
    const SheetDots dots = dots_for(format, style);
    const DrawnSheet seen = see_sheet(drawing, sheet, dots);
    DrawingToSave to_save{.dots = stream_of(drawing.stippling.dots, drawing.stippling.scale),
                          .page = seen.page,
                          .pens = drawing.pens,
                          .dot_radius_mm = drawing.dot_radius * seen.page.mm_per_page_unit,
                          .tiles = drawing.outlines,
                          .cut_marks = marks,
                          .picture = seen.picture,
                          .tile_size = file.tile_size,
                          .saving = file.saving,
                          .settings = embedded_settings(path, file.settings, file.saving)};
    if (!has_order(format, style)) to_save.saving.order = DotOrder::recursion;
    if (dots == SheetDots::of_the_page && sheet != Sheet{}) to_save.part_corner_mm = seen.corner_mm;
    return save_drawing(path, file.settings, to_save, watch);
}

}  // namespace

bool needs_thresholds(const DrawingFile& file) {
    const DrawingFormat format = drawing_format(file.path);
    return is_table(format) || (!has_pixels(format) && file.saving.order == DotOrder::priority);
}

bool save_placed(const DrawingFile& file, PlacedDrawing& drawing, const SavingWatch& watch) {
    const Sheet& sheets = file.settings.sheets;
    if (!is_several(sheets)) return save_sheet(file, file.path, {}, drawing, watch);
    const std::vector<Sheet> all = all_sheets(sheets);
    double saved = 0;
    for (const Sheet& sheet : all) {
        PlacedDrawing own = drawing;
        const auto show = [&](double share) {
            if (watch.progress) watch.progress((saved + share) / static_cast<double>(all.size()));
        };
        if (!save_sheet(file, sheet_file(file.path, name_of(sheet)), sheet, own, {watch.stop, show}))
            return false;
        ++saved;
    }
    save_assembly_plan(file.path, drawing.layout.page, sheets);
    return true;
}

}  // namespace dapple
