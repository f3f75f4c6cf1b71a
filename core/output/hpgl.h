#pragma once
// Dots for pen plotters that read HPGL.

#include <ostream>
#include <string_view>

#include "core/output/progress.h"
#include "core/output/sheet.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// Plotter units to the millimetre, which the language fixes.
inline constexpr int kHpglUnitsPerMm = 40;
/// The farthest place, in millimetres, that plotters of the language's first kind take: 32,767 units.
inline constexpr double kHpglReachMm = 32'767.0 / kHpglUnitsPerMm;

/// The first pen goes to each dot, down and up again, in the order given: PU4000,2000;PD; (a PD to where the
/// pen is already is a line of no length, which some readers leave out). Whole plotter units, 0.025 mm; the
/// origin is the page's lower left corner. The dots' size is the pen's. Needs the memory of a piece and a
/// buffer.
///
/// What `comment` says, if anything, stands at the beginning as CO "...";, without quotes or semicolons in
/// it. Plotters of the language's first kind do not know CO; the IN that follows clears such an error.
void write_hpgl(std::ostream& out, const DotStream& dots, const PageSize& page,
                const WritingProgress& progress = {}, std::span<const CutMark> registration = {},
                std::string_view comment = {});

/// The same for strokes; coordinates are rounded to the plotter's units, 0.025 mm.
void write_hpgl(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
                const WritingProgress& progress = {}, std::span<const CutMark> registration = {},
                std::string_view comment = {});

}  // namespace dapple
