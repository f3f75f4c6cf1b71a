#pragma once
// Dots for pen plotters that read HPGL.

#include <ostream>

#include "core/output/progress.h"
#include "core/output/sheet.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// Plotter units to the millimetre, which the language fixes.
inline constexpr int kHpglUnitsPerMm = 40;

/// The first pen goes to each dot, down and up again, in the order given: PU4000,2000;PD4000,2000; is a line
/// of no length, as plotters that ignore a PD without a place need it. Whole plotter units, 0.025 mm; the
/// origin is the page's lower left corner. The dots' size is the pen's. Needs the memory of a piece and a
/// buffer.
void write_hpgl(std::ostream& out, const DotStream& dots, const PageSize& page,
                const WritingProgress& progress = {}, std::span<const CutMark> registration = {});

/// The same of strokes; coordinates are rounded to the plotter's units, 0.025 mm.
void write_hpgl(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
                const WritingProgress& progress = {}, std::span<const CutMark> registration = {});

}  // namespace dapple
