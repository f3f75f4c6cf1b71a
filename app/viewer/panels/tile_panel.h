#pragma once
// The section "The tile": the points of the tile in use and the order in which they appear.

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

#include "app/viewer/background/tile_view.h"

namespace dapple {

/// How many of the tile's points are shown.
struct TilePanelState {
    std::size_t shown = SIZE_MAX;  // at most the tile's
};

/// The tile itself: its points in the order of their ranks, how it is turned in its quadrants, and a slider
/// that takes points away from the last on.
void draw_tile_panel(const TileView& tile, TilePanelState& state);

/// The strokes of the letter F, which looks different in all eight orientations: from and to, about the
/// centre, within -1..1, y down.
using Stroke = std::array<glm::dvec2, 2>;
std::array<Stroke, 3> letter_f(Orientation orientation);

}  // namespace dapple
