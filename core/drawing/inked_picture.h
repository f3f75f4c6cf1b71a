#pragma once
// A picture's lines and solid blacks, as its settings ask for them, and its density with room for them.

#include <span>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/density.h"
#include "core/image/grid.h"
#include "core/lines/inking.h"
#include "core/pens/pen.h"

namespace dapple {

/// The negative, in encoded values, for light ink.
Grid<float> negative(Grid<float> light);

/// The pen that draws lines and blacks: the darkest one's place in the palette, 0 if there are not several.
int pen_for_inking(std::span<const Pen> pens);

/// Those of the lines that a strength of 0..1 shows, the weaker ones thinner.
std::vector<InkLine> lines_shown(const std::vector<InkLine>& lines, double contours);

/// What of an inking's lines lies where the picture is drawn: where `kept`, a grid over the picture, is 0.5
/// or more.
Inking within(Inking inking, const Grid<float>& kept);

/// The density with that room in it: see room_for_dots().
Density with_room(const Density& density, const Grid<float>& room);

}  // namespace dapple
