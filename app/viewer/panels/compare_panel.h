#pragma once

#include <span>

#include "app/viewer/viewer_settings.h"

namespace dapple {

/// Section "Compare": the split view on or off, and what its right side is placed with; the loupe. True while
/// something changes.
bool draw_compare_panel(ViewerSettings& settings, std::span<const char* const> tiles);

}  // namespace dapple
