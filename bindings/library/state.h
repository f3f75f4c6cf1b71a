#pragma once
// What is behind the library's edge of more than one of its files.

#include <string_view>

#include "core/drawing/settings.h"
#include "core/tile/tile_file.h"
#include "dapple/settings.h"

namespace dapple {

struct Settings::State {
    DrawingSettings drawing;
    SavingChoice saving;
};

/// Throws std::runtime_error if so many cannot work.
int checked_threads(int threads);

/// What the settings' tile names. Throws as tile_text() does.
StoredTile stored_tile(std::string_view name);

}  // namespace dapple
