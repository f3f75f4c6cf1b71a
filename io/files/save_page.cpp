#include "io/files/save_page.h"

#include <vector>

#include "io/files/sheet_files.h"

namespace dapple {
namespace {

bool save(const DrawnPage& page, const PlannedDrawing& drawing, const DrawingFile& file,
          const std::filesystem::path& path, const SavingWatch& watch) {
    const DrawingToSave part = drawing_on(page, drawing, file, watch.stop);
    return !watch.stop.stop_requested() && save_drawing(path, file.settings, part, watch);
}

}  // namespace

bool save_page(const PlannedDrawing& drawing, const DrawingFile& file, const SavingWatch& watch) {
    const PageLayout layout = drawing.layout();
    if (!is_several(file.settings.sheets))
        return save(drawn_page(layout, file.saving), drawing, file, file.path, watch);
    const std::vector<Sheet> all = all_sheets(file.settings.sheets);
    double saved = 0;
    for (const Sheet& sheet : all) {
        const auto show = [&](double share) {
            if (watch.progress) watch.progress((saved + share) / static_cast<double>(all.size()));
        };
        if (!save(drawn_page(layout, sheet), drawing, file, sheet_file(file.path, name_of(sheet)),
                  {watch.stop, show}))
            return false;
        ++saved;
    }
    save_assembly_plan(file.path, layout.page, file.settings.sheets);
    return true;
}

}  // namespace dapple
