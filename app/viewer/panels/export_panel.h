#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/files/save_drawing.h"
#include "app/viewer/viewer_settings.h"

namespace dapple {

/// What saving would write.
struct ExportFacts {
    std::uint64_t dots = 0;
    std::optional<double> bytes;  // about; none if it cannot be written
    std::string trouble;          // why not
};

/// The room that the options need in the file dialog.
inline constexpr int kExportRows = 4;

/// What goes with a format: the order of the dots, paper, resolution; and how large the file will be. True
/// while something changes.
bool draw_export_panel(ViewerSettings& settings, DrawingFormat format, const ExportFacts& facts);

/// "about 24 MB, 400,000 dots".
std::string size_in_words(const ExportFacts& facts);

}  // namespace dapple
