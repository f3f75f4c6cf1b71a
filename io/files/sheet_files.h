#pragma once
// The files of a mural: one for each sheet, and the plan of how they join.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/drawing/settings.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/text/number_words.h"

namespace dapple {

/// "mural.svg" and "B3" become "mural-B3.svg", next to it.
std::filesystem::path sheet_file(const std::filesystem::path& drawing, const std::string& sheet);

/// "mural-plan.svg", whatever the drawing's format.
std::filesystem::path plan_file(const std::filesystem::path& drawing);

/// All that is written for a drawing of that name: itself, or the sheets and their plan; each with what there
/// is for each pen, see separations.h.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& drawing, const Sheet& sheets,
                                            const SavingChoice& saving = {}, std::span<const Pen> pens = {});

/// Writes the plan. Throws what save_atomically() throws.
void save_assembly_plan(const std::filesystem::path& drawing, const PageSize& page, const Sheet& sheets);

/// "12 sheets of 250 x 190 mm".
std::string sheets_in_words(const PageSize& page, const Sheet& sheets, LengthUnit unit = LengthUnit::mm);

/// "mural-A1.svg to mural-C4.svg, and mural-plan.svg shows how they join"; the first with its folder.
std::string sheet_files_in_words(const std::filesystem::path& drawing, const Sheet& sheets);

}  // namespace dapple
