#pragma once
// What the window saves: a drawing in a file, or its sheets in several.

#include <filesystem>

#include "app/files/save_drawing.h"
#include "app/viewer/model/placed_drawing.h"

namespace dapple {

struct DrawingFile {
    std::filesystem::path path;
    DrawingSettings settings;
    SavingChoice saving;
    std::size_t tile_size = 16;  // N
};

/// Whether the dots have to tell when they appear.
bool needs_thresholds(const DrawingFile& file);

/// Writes files_of() it. False if stopped: sheets that were written before then stay. Uses the drawing up.
/// Throws what save_drawing() throws, or if the sheets' overlap is too wide.
bool save_placed(const DrawingFile& file, PlacedDrawing& drawing, const SavingWatch& watch);

}  // namespace dapple
