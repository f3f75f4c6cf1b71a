#pragma once
// What a plotter will make of strokes: how far the pen goes, and how long that takes.

#include <cstdint>

#include "core/output/machine_clock.h"
#include "core/strokes/strokes.h"

namespace dapple {

struct StrokeFigures {
    double drawn_m = 0;     // with the pen down, in metres
    double pen_up_m = 0;    // from each stroke's end to the next one's begin
    double longest_mm = 0;  // straight on with the pen down, as between two dots of a line through them
    std::uint64_t strokes = 0;
    std::uint64_t segments = 0;  // straight pieces that are drawn
    PlottingTime time;

    bool operator==(const StrokeFigures&) const = default;
};

/// In the order of the strokes.
StrokeFigures figures_of(const StrokeStream& strokes, const MachineProgram& program);

/// The time for circles, each drawn once along its outline, in the dots' order. `dot_radius_mm` is for dots
/// that have no radius of their own.
PlottingTime plotting_time_of_rings(const DotStream& dots, double mm_per_page_unit, double dot_radius_mm,
                                    const MachineProgram& program);

}  // namespace dapple
