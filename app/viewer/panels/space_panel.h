#pragma once
// The section "In space": the same construction in three dimensions.

#include "app/viewer/background/space_dots.h"

namespace dapple {

/// Folded at first. True while it is open, for only then is there a card with its picture over the canvas.
bool draw_space_panel(SpaceSettings& settings);

}  // namespace dapple
