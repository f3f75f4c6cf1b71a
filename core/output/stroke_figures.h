#pragma once
// What a plotter will make of strokes: how far the pen goes, and how long that takes.

#include <cstdint>

#include "core/output/plotting_time.h"
#include "core/placing/dots.h"
#include "core/strokes/strokes.h"

namespace dapple {

struct StrokeFigures {
    double drawn_m = 0;     // with the pen down, in metres
    double pen_up_m = 0;    // from each stroke's end to the next one's begin
    double longest_mm = 0;  // straight on with the pen down, as between two dots of a line through them
    std::uint64_t strokes = 0;
    PlottingTime time;

    bool operator==(const StrokeFigures&) const = default;
};

/// In the order of the strokes. Where a line goes on into the next the pen is as fast as its turn allows: the
/// cosine of that times the drawing speed, and it stops where it turns by a right angle or more; in between,
/// it gains and loses speed with the machine's acceleration (the look-ahead that Grbl and the AxiDraw's
/// program have, with a simpler rule for corners).
StrokeFigures figures_of(const StrokeStream& strokes, const MachineSpeeds& speeds);

/// The time for circles, each drawn once along its outline, in the dots' order. `dot_radius_mm` is for dots
/// that have no radius of their own.
PlottingTime plotting_time_of_rings(const Dots& dots, double mm_per_page_unit, double dot_radius_mm,
                                    const MachineSpeeds& speeds);

/// Seconds for one stroke, from rest to rest.
double drawing_time(std::span<const glm::dvec2> points_mm, const MachineSpeeds& speeds);

}  // namespace dapple
