#include "app/files/save_page.h"

#include <vector>

#include "app/files/sheet_files.h"

namespace dapple {
namespace {

bool save(const DrawnPage& page, const DotsForFile& dots, const std::filesystem::path& path,
          const SavingWatch& watch) {
    const DrawingToSave drawing = drawing_on(page, dots, watch.stop);
    return !watch.stop.stop_requested() && save_drawing(path, dots.file.settings, drawing, watch);
}

}  // namespace

bool save_page(const DotsForFile& dots, const SavingWatch& watch) {
    const DrawingFile& file = dots.file;
    const PageLayout layout = dots.plan.layout(dots.dots.scale);
    if (!is_several(file.settings.sheets)) return save(drawn_page(layout), dots, file.path, watch);
    const std::vector<Sheet> all = all_sheets(file.settings.sheets);
    double saved = 0;
    for (const Sheet& sheet : all) {
        const auto show = [&](double share) {
            if (watch.progress) watch.progress((saved + share) / static_cast<double>(all.size()));
        };
        if (!save(drawn_page(layout, sheet), dots, sheet_file(file.path, name_of(sheet)), {watch.stop, show}))
            return false;
        ++saved;
    }
    save_assembly_plan(file.path, layout.page, file.settings.sheets);
    return true;
}

}  // namespace dapple
