#pragma once
// The message over the canvas.

#include <glm/vec2.hpp>

#include "app/viewer/model/banner.h"

namespace dapple {

/// Seconds until a notice looks different; 0: it fades. Infinity if it stays as it is.
double seconds_until_change(const Banner& banner);

/// Draws it within a rectangle; clicking the cross empties it. True when its offer is taken.
bool draw_banner(Banner& banner, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
