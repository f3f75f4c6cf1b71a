#pragma once
// What can be told of a drawing once its dots are there: measured, timed, and found worth knowing before it
// is plotted.

#include <optional>
#include <vector>

#include "core/drawing/drawing.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/drawing/write_drawing.h"
#include "core/output/findings.h"
#include "core/output/pen_figures.h"
#include "core/output/plotting_time.h"

namespace dapple {

// What is known of a drawing before it is plotted, for the command and the window alike: see
// core/output/findings.h.

/// How such a file brings the dots onto the paper.
DotsAs dots_as(const DrawingFile& file);

/// How far the ink of its dots reaches. Where a machine touches the paper and nothing says how large dots
/// are, they are as wide as the pen's line.
InkedDot inked_dot(const DrawingToSave& drawing);

/// All that follows from the settings. Left to whoever has the dots: what is measured, the plotting time, the
/// pens, and the tone of dots of a size of their own.
DrawingFacts facts_of(const DrawingToSave& drawing);

struct DrawingFigures {
    std::optional<Preflight> preflight = {};  // if its dots are in memory
    std::vector<Finding> findings = {};       // what someone should know of it
    Machine machine = {};                     // that would draw it
    std::optional<PlottingTime> plotting = {};
    std::optional<StrokeFigures> strokes = {};  // none where dots are circles or points
    std::vector<PenFigures> by_pen = {};        // of those that draw something
    std::optional<PenEvenness> evenness = {};   // of a whole page
};

/// Of a drawing that lies so on its page. `by_pen`: its dots in memory, as they are drawn; null if they are
/// too many.
DrawingFigures figures_of(const DrawingPlan& plan, const DrawnPage& page, const DrawingToSave& drawing,
                          const DotPieces* by_pen);

}  // namespace dapple
