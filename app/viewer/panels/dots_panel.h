#pragma once
// The section "Dots": how many, how large, how they are placed and relaxed.

#include "app/viewer/model/drawn_info.h"
#include "app/viewer/panels/tile_row.h"

namespace dapple {

/// The order of a tile's dots. True when another was chosen.
bool ranking_row(const char* label, std::optional<RankingMethod>& ranking);

/// Placer, tile, how many dots and how large. True while something changes.
bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn, const TileList& tiles);

}  // namespace dapple
