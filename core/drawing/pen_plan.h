#pragma once
// The pens of a drawing, and what each of them draws of a picture in colour.

#include <glm/vec3.hpp>
#include <optional>

#include "core/image/colour.h"
#include "core/image/ink.h"
#include "core/pens/pen_dots.h"
#include "core/pens/separation.h"

namespace dapple {

/// The pens that the choice comes to on a picture, in its order; none for one pen. Automatic ones are
/// chosen by about 500 of its pixels, in light that is `exposure` stops lighter; for a grey picture only
/// greys, if there are any. The ink of all of them is the choice's; opaque where one of them, as white on
/// brown paper, would hardly be seen in transparent ink.
Palette pens_for(const PenChoice& choice, const ColourGrid& colours, float exposure, glm::vec3 paper);

/// The colours of a picture whose tone is to be seen as `seen`, linear light 0..1: each is made lighter or
/// darker until it has that luminance, and paler where it would be too bright. `colours` are as large as
/// `seen`, or empty for a grey picture. `invert`: the negative.
struct ColourTone {
    const Grid<float>& seen;
    const ColourGrid& colours;
    bool invert = false;
};
glm::vec3 colour_at(const ColourTone& tone, int x, int y);

/// How even all dots of a drawing are once many pens have shared and moved them (core/pens/pen_dots.h): as
/// even as after so many steps of relaxation. `steps` is how many there were before that.
int steps_among_pens(int steps);

/// Each pen's density, so that its dots are seen on the share of paper that its separation asks for. Where
/// pens have widths of their own, dot gain and all, a thin one has more dots.
///
/// How much lies under other dots follows from the number of all dots and what they cover, which depends on
/// how even they are: dots that many pens share are less even than those of one pen, as they are moved for
/// their own pens too. A pen's own dots overlap less than by chance, as Demichel's areas (1924) have it, and
/// so do pairs of pens that both have few. Where opaque inks overlap the upper one is seen. Where transparent
/// ones do, the paper's light is multiplied by both (Neugebauer 1937), in pairs; a third dot on top is left
/// out of account, and so is light that spreads in the paper (Yule & Nielsen 1951), as it does not on the
/// screen.
///
/// `dots` were relaxed for steps_among_pens().
PenDensities separated(const ColourTone& tone, const Separation& separation, std::span<const Pen> pens,
                       const InkedDots& dots);

/// The radius of a pen's dots, in millimetres, where all dots together have `usual`; see dot_width_mm().
double dot_radius_mm(const Pen& pen, double usual);

/// The area of a dot of each pen, over the widest one's.
std::vector<double> dot_areas(std::span<const Pen> pens);

/// The width that all dots are drawn as large as, in millimetres, if a pen says so: the widest dots'.
std::optional<double> width_of_pens(std::span<const Pen> pens);

}  // namespace dapple
