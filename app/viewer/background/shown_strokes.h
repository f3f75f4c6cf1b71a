#pragma once
// What a pen would draw, as lines for the canvas.

#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "core/drawing/settings.h"
#include "core/lines/inking.h"
#include "core/pens/pen.h"
#include "core/placing/dot_order.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

struct ShownStrokes {
    std::vector<glm::vec4> lines;  // from x, y to x, y in page units; a touch has no length
    std::vector<DotBlock> blocks;  // of the lines, with the boxes around them
    double width = 0;              // page units; of the widest pen
    // For each line, where several pens draw; empty: all in ink, all as wide.
    std::vector<float> widths;       // page units
    std::vector<std::uint8_t> pens;  // places in the drawing's palette
};

enum class LineWay {
    soon,   // along a Hilbert curve
    final,  // as a file has it
};

/// The same as in a file; a file's longest lines are told in millimetres, these in page units from the
/// picture's corner. None where there would be more than 20 million: dots are then shown as circles. Stopped,
/// it is what was reached. `order` is that of one line through all dots, the shortest if there is none;
/// `pens` are the drawing's, if there are several.
ShownStrokes shown_strokes(const DotPieces& dots, const DrawingSettings& settings,
                           std::optional<DotOrder> order, std::span<const Pen> pens, const PageSize& page,
                           double dot_radius, LineWay way, const std::stop_token& stop = {});

/// Lines and solid blacks among the dots, seen from a window's corner in page units.
ShownStrokes shown_inking(const Inking& inking, std::span<const Pen> pens, glm::dvec2 corner);

/// Strokes as they are, in millimetres from the picture's corner. None where there would be so many.
ShownStrokes on_screen(const StrokeStream& strokes, std::span<const Pen> pens, double mm_per_page_unit);

}  // namespace dapple
