#pragma once
// What the left button does over the canvas: the brush that paints the drawing's mask, and the hand that
// retouches single dots.

#include <algorithm>
#include <cmath>

#include "core/image/mask.h"
#include "core/text/names.h"

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

/// What the left button does with dots. size: drags one larger; whiten: a brush that leaves none.
enum class Hand { remove, add, move, size, whiten, lasso };
constexpr auto names_of(Hand) {
    return names("remove", "add", "move", "size", "whiten", "lasso");
}

struct RetouchTool {
    bool on = false;
    Hand hand = Hand::remove;
    double brush_mm = 2;  // its radius on the paper
};

}  // namespace dapple
