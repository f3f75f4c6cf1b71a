#pragma once
// A drawing as SVG that plotters' and illustrators' programs read at once.
//
// The root has its size in millimetres and a viewBox; coordinates are in px of 96 to the inch, so readers
// that ignore the viewBox are right too. Each pen has a layer, a direct child of the root, numbered first in
// its label: "1 Black"; one of transparent ink multiplies what lies below it. What no pen is to draw is in
// layers whose names begin with %, which AxiDraw's software skips: the tiles' outlines in "% Tiles" and,
// where it is asked for, the background in "% Background".

#include <glm/vec3.hpp>
#include <optional>
#include <ostream>
#include <span>
#include <string_view>

#include "core/image/colour.h"
#include "core/image/rectangle.h"
#include "core/output/progress.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// What holds the settings that a drawing was made with, in <metadata>.
inline constexpr const char* kSvgSettingsElement = "dapple:settings";

struct SvgStyle {
    double dot_radius_mm = 0.2;  // where dots have none of their own; 0.001 px at least: readers drop circles
                                 // of radius 0
    glm::vec3 ink = kBlack;
    std::span<const Pen> pens =
        {};  // several: each dot's or stroke's is one of them, with a layer of its own
    std::span<const CutMark> registration = {};  // registration_marks(): lines that each of these draws
    std::optional<glm::vec3> background;         // a rectangle under everything
    std::span<const PlacedTile> tiles = {};      // their outlines, coloured by level; none, no layer
    std::optional<Rectangle<double>> picture =
        {};                                   // page units: outlines end at its edges; none: at the page's
    std::span<const CutMark> cut_marks = {};  // of a sheet, the last layer: "2 Cut marks"; none, no layer
    std::string_view settings =
        {};  // text without <, > and & for whoever opens the drawing again; empty: no <metadata>
};

/// One filled circle for each dot, in the order given. Coordinates have two decimals of a px, or three where
/// dots are dense. Needs the memory of a piece and a buffer.
void write_svg(std::ostream& out, const DotStream& dots, const PageSize& page, const SvgStyle& style,
               const WritingProgress& progress = {});

/// The same for strokes: a path for each, as wide as the pen and with round ends, in the layer of the pen. A
/// touch is a line of 0.05 mm, since readers drop what has no length.
void write_svg(std::ostream& out, const StrokeStream& strokes, const PageSize& page, const SvgStyle& style,
               const WritingProgress& progress = {});

}  // namespace dapple
