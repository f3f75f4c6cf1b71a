#pragma once
// The pens of a drawing, and what each of them draws of a picture in colour.

#include <glm/vec3.hpp>
#include <optional>

#include "core/image/ink.h"
#include "core/image/linear_colour.h"
#include "core/pens/pen_dots.h"
#include "core/pens/separation.h"

namespace dapple {

/// The pens that the choice comes to on a picture, in its order; none for one pen. Automatic ones are
/// chosen by about 500 of its pixels, in light that is `exposure` stops lighter.
Palette pens_for(const PenChoice& choice, const ColourGrid& colours, float exposure, glm::vec3 paper);

/// Of a picture whose tone is to be seen as `seen`, linear light 0..1: each colour is made lighter or darker
/// until it has that luminance, and paler where it would be too bright. Inverted: the negative. Without
/// colours, which are else as large as `seen`, it is grey.
struct ColourTone {
    const Grid<float>& seen;
    const ColourGrid& colours;
    bool invert = false;
};
glm::vec3 colour_at(const ColourTone& tone, int x, int y);

/// Each pen's density, so that its dots cover the share of paper that its separation asks for. Where pens
/// have widths of their own, dot gain and all, a thin one has more dots.
PenDensities separated(const ColourTone& tone, const Separation& separation, std::span<const Pen> pens,
                       const InkCurve& ink);

/// The radius of a pen's dots, in millimetres, where all dots together have `usual`; see dot_width_mm().
double dot_radius_mm(const Pen& pen, double usual);

/// The width that all dots are drawn as large as, in millimetres, if a pen says so: the widest dots'.
std::optional<double> width_of_pens(std::span<const Pen> pens);

}  // namespace dapple
