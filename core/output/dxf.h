#pragma once
// Dots for CAD programs and for those of lasers and mills.

#include <ostream>

#include "core/output/progress.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// ASCII DXF of release 12, which all programs read: a CIRCLE for each dot on the layer "Dots", in the order
/// given. Circles rather than POINTs: they keep the dots' radii, and many lasers' programs leave points out.
/// In millimetres with three decimals, although no DXF of that release can say so; the origin is the page's
/// lower left corner. A radius is 0.001 mm at least, as readers refuse 0. Needs the memory of a piece and a
/// buffer.
void write_dxf(std::ostream& out, const DotStream& dots, const PageSize& page, double dot_radius_mm,
               const WritingProgress& progress = {});

/// The same of strokes: a polyline each, on the layer "Lines"; a touch is a point.
void write_dxf(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
               const WritingProgress& progress = {});

}  // namespace dapple
