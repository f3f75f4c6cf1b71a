#pragma once
// The line between the two sides of the split view, with a handle to drag it by.

#include "app/viewer/canvas/canvas.h"

namespace dapple {

/// Draws it over the canvas and moves it with the mouse. `share`: of the canvas's width to its left; it stays
/// so far from the edges that the handle can always be reached. True while it moves.
bool draw_split_divider(float& share, const CanvasPlace& place);

}  // namespace dapple
