#pragma once
// Letters that a pen draws, as plotters have no fonts: digits, capitals and . - + ( ) _, in few straight
// lines.
//
// A letter is two thirds as wide as it is high, and the next one begins its height further on:
//
//      0   4  6
//      +---+--+-- 0     "0602204246 0444" is an A: each pair of digits is a point, across and down, and a
//      | A |  | B       blank raises the pen
//      +---+--+-- 6

#include <glm/vec2.hpp>
#include <string_view>

#include "core/strokes/strokes.h"

namespace dapple {

/// Adds the text as lines of that pen: `corner` is the first letter's upper left one, in millimetres. Small
/// letters are drawn as capitals; of what has no letter here the place stays empty.
void add_text(Strokes& strokes, std::string_view text, glm::dvec2 corner, double height_mm, int pen);

/// How long such a text is.
double text_width_mm(std::string_view text, double height_mm);

}  // namespace dapple
