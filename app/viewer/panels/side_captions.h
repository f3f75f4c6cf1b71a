#pragma once
// What each side of the split view shows, under it.

#include <glm/vec2.hpp>

#include "app/viewer/model/compared_panes.h"

namespace dapple {

/// The height of the strip that they need.
float side_captions_height();

/// Draws into a strip below the canvas, in the middle of each side of the divider, what it is drawn with and
/// what that came to. On a side too narrow for it a line ends in dots.
void draw_side_captions(const ComparedPanes& compared, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
