#pragma once
// The section "Compare": the split view and what its right side is drawn with.

#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/panels/tile_row.h"

namespace dapple {

/// Section "Compare": the split view on or off, and what its right side is placed with; the loupe. True while
/// something changes.
bool draw_compare_panel(ViewerSettings& settings, const TileList& tiles);

}  // namespace dapple
