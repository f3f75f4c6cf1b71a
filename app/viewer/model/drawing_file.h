#pragma once
// What the window saves: a drawing in a file.

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

/// Writes it. False if stopped. Uses the drawing up. Throws what save_drawing() throws.
bool save_placed(const DrawingFile& file, PlacedDrawing& drawing, const SavingWatch& watch);

}  // namespace dapple
