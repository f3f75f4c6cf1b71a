#pragma once
// The brush that paints the drawing's mask in the window.

#include <algorithm>
#include <cmath>

#include "core/image/mask.h"

namespace dapple {

struct MaskBrush {
    bool on = false;  // the left button paints, rather than moving the page
    Brush brush = {.kind = BrushKind::none};
};

/// The limits of its radius, in the picture's longer sides.
inline constexpr double kSmallestBrush = 0.002, kLargestBrush = 1;

/// The brush made larger by so many steps, or smaller; three of them are about twice the radius.
inline void resize_brush(MaskBrush& tool, int steps) {
    tool.brush.radius = std::clamp(tool.brush.radius * std::pow(1.25, steps), kSmallestBrush, kLargestBrush);
}

}  // namespace dapple
