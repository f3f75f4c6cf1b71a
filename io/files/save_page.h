#pragma once
// A page into its file, or its sheets into theirs.

#include "core/drawing/drawing_file.h"
#include "io/files/save_drawing.h"

namespace dapple {

/// Writes the page or the region of it that is chosen, or its sheets and their plan: see files_of() in
/// sheet_files.h. False if stopped: sheets that were written before then stay. Throws what save_drawing()
/// throws, or if the sheets' overlap is too wide or the region does not lie on the page.
bool save_page(const PlannedDrawing& drawing, const DrawingFile& file, const SavingWatch& watch);

}  // namespace dapple
