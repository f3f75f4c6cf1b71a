#pragma once
// A dot as a pen draws it, instead of as a filled circle.

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/export.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/strokes/strokes.h"
#include "core/text/names.h"

namespace dapple {

enum class DotShape {
    circle,  // filled: what printers print and lasers burn; no strokes
    point,   // the pen goes down and up
    stroke,  // a short one, slanting upwards to the right
    spiral,  // from the middle outwards, its turns a pen's width apart, so that it is filled
    hatch,   // to and fro, a pen's width apart
    ring,
    cross,
    path,  // of one's own
};
constexpr auto names_of(DotShape) {
    return names("circle", "point", "stroke", "spiral", "hatch", "ring", "cross", "path");
}

/// Whether the ink is a disc of the dot's radius: circle, point, spiral and hatch.
bool is_disc(DotShape shape);

struct DotMark {
    DotShape shape = DotShape::circle;
    std::string path = {};  // for DotShape::path: see parse_dot_path()

    bool operator==(const DotMark&) const = default;
};

/// What --dot-shape takes: a shape's name, or a path. Throws std::runtime_error saying what is wrong.
DAPPLE_API DotMark parse_dot_mark(std::string_view text);

/// Its name, or its path.
std::string text_of(const DotMark& mark);

/// An SVG path's d, in a box from 0,0 at the upper left to 1,1: M, L, H, V, C, Q, A and Z in capitals with as
/// many numbers as they need, blanks or commas between those. Curves become short lines. Throws
/// std::runtime_error telling what is wrong, also of a path that leaves the box.
Strokes parse_dot_path(std::string_view d);

/// The shape about 0,0, of a dot of that radius drawn by a pen of that width, in millimetres: all ink, with
/// half the pen's width on each side, lies within the radius, but for the corners of a path's box, which is
/// as wide and high as the dot. Where the pen is too wide for that, a touch.
Strokes mark_of(const DotMark& mark, double radius_mm, double pen_width_mm);

/// All dots so, one after the other. `radius_mm` is of dots that have none of their own. The stream of the
/// dots has to outlive it. Not for circles. Several pens may have widths of their own.
StrokeStream marks_of(const DotStream& dots, const PageSize& page, const DotMark& mark, double radius_mm,
                      double pen_width_mm, const std::vector<double>& pen_widths_mm = {});

}  // namespace dapple
