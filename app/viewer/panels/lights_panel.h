#pragma once
// The column beside an environment map: its samples, its view, how good they are.

#include <optional>

#include "app/viewer/model/lit_map.h"
#include "app/viewer/panels/method_panels.h"
#include "io/files/save_lights.h"

namespace dapple {

/// Sections "Samples" and "View", and the figures. True while something changes. `tiles` can be chosen from.
/// Without them the samples are still being taken, and it says so in their place.
bool draw_lights_panel(LightsSettings& settings, const std::optional<LightsInfo>& info,
                       const TileList& tiles);

/// What goes with a kind of file: the axes of its directions. True when another is chosen.
bool draw_light_export_panel(LightsSettings& settings, LightFile format);

}  // namespace dapple
