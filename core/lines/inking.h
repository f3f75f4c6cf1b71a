#pragma once
// The lines and solid blacks of a drawing, among its dots: as shapes to be filled, as strokes of a pen, and
// what room they leave for dots.

#include <functional>
#include <vector>

#include "core/image/density.h"
#include "core/image/grid.h"
#include "core/image/ink.h"
#include "core/image/rectangle.h"
#include "core/lines/ink_areas.h"
#include "core/lines/ink_lines.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// In page units from the picture's upper left corner.
struct Inking {
    std::vector<InkLine> lines;
    std::vector<InkArea> areas;
    std::vector<InkLine> white;  // left bare among dots that are nearly black

    bool empty() const { return lines.empty() && areas.empty(); }
};

/// All of it as shapes, in millimetres from the corner of a part of the page, `part` in page units: lines
/// with their widths, round at their ends. What lies beyond the part's edges is cut off. A point is inside
/// where rings go around it more often one way than the other.
std::vector<InkArea> shapes_of(const Inking& inking, const Rectangle<double>& part, double mm_per_page_unit);

/// Rings of short straight lines along the area's smooth outline, for what does not draw curves.
InkArea flattened(InkArea area);

/// All of it as a pen of that width draws it, in millimetres from the picture's corner, in an order that is
/// short to go: a line in as many passes as make it wide, an area around its edge and then to and fro.
Strokes strokes_of(const Inking& inking, double pen_width_mm, double mm_per_page_unit);

/// The inking of a page, or of a part of it, in millimetres from its corner, in one of two forms.
struct DrawnInking {
    std::vector<InkArea> shapes;  // where ink fills
    Strokes strokes;              // where a pen draws; it is as wide as the page's lines
    int pen = 0;                  // that draws it, its place in the palette

    bool empty() const { return shapes.empty() && strokes.points.empty(); }
};

/// The negative, in encoded values, for light ink.
Grid<float> negative(Grid<float> light);

/// Those of the lines that a strength of 0..1 shows, the weaker ones thinner.
std::vector<InkLine> lines_shown(const std::vector<InkLine>& lines, double contours);

/// What of an inking's lines lies where the picture is drawn, and all of its areas.
Inking within(Inking inking, const std::function<bool(glm::dvec2 place)>& is_drawn);

/// The density with that room in it: see room_for_dots().
Density with_room(const Density& density, const Grid<float>& room);

/// The dots that the inking lies among, in page units.
struct DotsAmongLines {
    double radius = 0;   // of the largest
    double spacing = 0;  // on the mean

    bool operator==(const DotsAmongLines&) const = default;
};

/// The lines for a drawing with such dots: none is much finer than these, and where both sides of one are so
/// dark that it would be lost, it is white. `seen` is the light of the drawn picture, 0..1,
/// as small as reduced() makes it.
Inking fitted(Inking inking, const Grid<float>& seen, const DotsAmongLines& dots);

/// What the density is to be multiplied with at each of its pixels, as many as reduced() leaves: 0 where dots
/// would reach into lines and areas or nearly, and where they would stand alone, at over three times the
/// usual distance from each other. Dots that are nearly black come up to them: no white rim parts them. What
/// ink the lines carry beyond the tone, and what the gaps lack of it, is made up for by the dots beside them.
Grid<float> room_for_dots(const Inking& inking, const Density& density, const Grid<float>& seen,
                          const InkCurve& ink, const DotsAmongLines& dots);

}  // namespace dapple
