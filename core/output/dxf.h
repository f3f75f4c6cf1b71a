#pragma once
// Dots for CAD programs and for those of lasers and mills.

#include <ostream>
#include <span>

#include "core/output/progress.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// ASCII DXF of AutoCAD 2000 (AC1015), the first release whose files name their unit: a CIRCLE for each dot
/// on the layer "Dots", in the order given. Circles rather than POINTs: they keep the dots' radii, and many
/// lasers' programs leave points out. In millimetres ($INSUNITS 4) with three decimals; the origin is the
/// page's lower left corner. Where several pens draw, each has a layer of its own instead, "1_Cyan", in the
/// nearest of the 255 colours that a DXF knows. A radius is 0.001 mm at least, as readers refuse 0. Needs the
/// memory of a piece and a buffer.
void write_dxf(std::ostream& out, const DotStream& dots, const PageSize& page, double dot_radius_mm,
               std::span<const Pen> pens = {}, const WritingProgress& progress = {},
               std::span<const CutMark> registration = {});

/// The same for strokes: an LWPOLYLINE each, on the layer "Lines"; a touch is a point.
void write_dxf(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
               std::span<const Pen> pens = {}, const WritingProgress& progress = {},
               std::span<const CutMark> registration = {});

}  // namespace dapple
