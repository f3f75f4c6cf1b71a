#pragma once
// What the file dialog asks beside a name when a drawing is saved.

#include <string>

#include "app/viewer/model/export_estimate.h"

namespace dapple {

/// What goes with a format: the order of the dots, paper, resolution; and how large the file will be. True
/// while something changes.
bool draw_export_panel(ViewerSettings& settings, DrawingFormat format, const ExportInfo& info);

/// "about 24 MB, 400,000 dots".
std::string size_in_words(const ExportInfo& info);

}  // namespace dapple
