#include "io/files/sheet_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ostream>

#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/save_drawing.h"
#include "io/files/separations.h"

namespace dapple {

namespace fs = std::filesystem;

fs::path sheet_file(const fs::path& drawing, const std::string& sheet) {
    fs::path file = drawing;
    file.replace_filename(drawing.stem().concat("-" + sheet).concat(drawing.extension().native()));
    return file;
}

fs::path plan_file(const fs::path& drawing) {
    return sheet_file(drawing, "plan").replace_extension(".svg");
}

std::vector<fs::path> files_of(const fs::path& drawing, const Sheet& sheets, const SavingChoice& saving,
                               std::span<const Pen> pens) {
    const DrawingFormat format = drawing_format(drawing);
    if (!is_several(sheets)) return files_of(drawing, format, saving, pens);
    std::vector<fs::path> files;
    for (const Sheet& sheet : all_sheets(sheets))
        std::ranges::copy(files_of(sheet_file(drawing, name_of(sheet)), format, saving, pens),
                          std::back_inserter(files));
    files.push_back(plan_file(drawing));
    return files;
}

void save_assembly_plan(const fs::path& drawing, const PageSize& page, const Sheet& sheets) {
    const AssemblyPlan plan{.page = page,
                            .sheets = sheets,
                            .name = drawing.stem().string(),
                            .ending = drawing.extension().string()};
    save_atomically(plan_file(drawing), [&](std::ostream& out) { write_assembly_plan(out, plan); });
}

std::string sheets_in_words(const PageSize& page, const Sheet& sheets, LengthUnit unit) {
    const PageSize size = sheet_of(page, sheets).size;
    const bool inches = unit == LengthUnit::inch;
    const double mm = inches ? kMmPerInch : 1;
    return fmt::format("{} sheets of {:.4g} x {:.4g} {}", sheets.columns * sheets.rows, size.width_mm / mm,
                       size.height_mm / mm, inches ? "in" : "mm");
}

std::string sheet_files_in_words(const fs::path& drawing, const Sheet& sheets) {
    const std::vector<Sheet> all = all_sheets(sheets);
    return fmt::format("{} to {}, and {} shows how they join",
                       printable(sheet_file(drawing, name_of(all.front())).native()),
                       printable(sheet_file(drawing, name_of(all.back())).filename().native()),
                       printable(plan_file(drawing).filename().native()));
}

}  // namespace dapple
