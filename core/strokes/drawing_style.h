#pragma once
// How a drawing's dots come onto the paper: each by itself, or lines from dot to dot.

#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"
#include "core/text/names.h"

namespace dapple {

enum class DrawingStyle {
    dots,     // each by itself, in the shape that DotMark says
    line,     // one line through all of them, in the order given
    nearest,  // each joined with its nearest few; no two lines cross
};
constexpr auto names_of(DrawingStyle) {
    return names("dots", "line", "nearest");
}

/// One line through all dots as they come: along a short way (core/routing/short_way.h) it is what is known
/// as TSP art (Bosch and Herman 2004). A single dot is a touch. Dots::pen draws it.
Strokes line_through(const Dots& dots, const PageSize& page);

/// The relative neighbourhood graph (Toussaint 1980): two dots are joined if none is nearer to both of them
/// than they are to each other. No two of its lines cross, and each dot's nearest is joined with it. Only
/// lines to one of a dot's 8 nearest are looked for, which leaves away the few that bridge a gap between
/// crowds. Drawn in strokes that go on as long as there is a line to take, beginning at dots in their order.
Strokes lines_to_nearest(const Dots& dots, const PageSize& page);

}  // namespace dapple
