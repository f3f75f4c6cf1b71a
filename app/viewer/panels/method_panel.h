#pragma once
// "The method", which takes the column's place: which tile the dots come from and how they are taken out of
// it, for whoever wants to know. The usual choices are good ones.

#include <functional>
#include <optional>
#include <span>

#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/panels/tile_row.h"

namespace dapple {

/// True while something changes.
bool draw_method_rows(ViewerSettings& settings, const TileList& tiles);

/// Buttons side by side that begin films; the first has the most room.
void draw_film_buttons(std::span<const Action> films, const std::function<void(Action)>& act);

/// The ranking, by which a tile's points become dots. True when another was chosen.
bool ranking_row(const char* label, std::optional<RankingMethod>& ranking);

/// Why rows that only the exact placer knows are absent; null if they are not.
const char* why_only_exact(PlacerKind placer);

}  // namespace dapple
