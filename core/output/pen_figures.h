#pragma once
// What several pens come to, each by itself: told before they are plotted.

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/distances.h"
#include "core/lines/inking.h"
#include "core/output/plotting_time.h"
#include "core/pens/pen.h"
#include "core/pens/pen_dots.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

// What a plotter will make of strokes: how far the pen goes, and how long that takes.

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

/// The time for lines and solid blacks that a pen draws by themselves.
PlottingTime time_of(const DrawnInking& inking, const MachineProgram& program);

/// The time for circles, each drawn once along its outline, in the dots' order. `dot_radius_mm` is for dots
/// that have no radius of their own.
PlottingTime plotting_time_of_rings(const DotStream& dots, double mm_per_page_unit, double dot_radius_mm,
                                    const MachineProgram& program);

struct PenFigures {
    int pen = 0;  // its place in the palette
    std::uint64_t dots = 0;
    double pen_up_m = 0;                // from dot to dot, in metres
    double nearest_mm = 0;              // smallest distance of two of its dots; infinite if there are not two
    std::uint64_t nearer_than_gap = 0;  // of its dots: with another one of them nearer than Pen::gap_mm
    PlottingTime time = {};
};

/// The figures of each piece, which is a pen's dots in the order of plotting; their time is left out.
std::vector<PenFigures> pen_figures(const DotPieces& by_pen, const PageSize& page, std::span<const Pen> pens);

/// How even the dots of several pens are, and how near each pen comes to what it is to draw.
struct PenEvenness {
    LocalDistances all;  // of all pens' dots together
    struct Own {
        LocalDistances distances;
        double wanted = 0;  // dots that the pen's density asks for
    };
    std::vector<Own> each;  // as the palette
};

/// The evenness of a whole page's dots that were placed at that scale. `corner` is where they count from, in
/// page units from the picture's corner.
PenEvenness pen_evenness(const DotPieces& by_pen, glm::dvec2 corner, const PenDensities& densities,
                         double scale);

}  // namespace dapple
