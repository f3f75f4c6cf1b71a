#pragma once
// What becomes of a drawing's dots on paper, measured before it is plotted: how near they are to each other
// and to the edges. core/output/findings.h says what of it someone should know.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/image/rectangle.h"
#include "core/placing/dot_stream.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"

namespace dapple {

/// Path ends nearer than this, in millimetres, are joined: the pen stays down between the two dots.
inline constexpr double kSaxiJoins = 0.5;
inline constexpr double kAxiDrawJoins = 0.152;

struct Preflight {
    double pen_up_m = 0;                 // the pen's way from dot to dot, in the order given, in metres
    double nearest_mm = 0;               // smallest distance between two dots; infinite if there are not two
    double first_percentile_mm = 0;      // one dot in a hundred has another one nearer than this; or infinite
    std::uint64_t nearer_than_saxi = 0;  // dots with another one nearer than kSaxiJoins
    std::uint64_t nearer_than_axidraw = 0;
    std::uint64_t overlapping = 0;      // dots that reach into others; of unequal radii into near ones
    double rings_m = 0;                 // all dots' outlines, in metres: what a plotter traces of circles
    std::uint64_t over_edge = 0;        // dots that reach over the page's edge, each as far as its own radius
    std::uint64_t outside_margins = 0;  // dots with a part outside of what the margins leave

    bool operator==(const Preflight&) const = default;
};

/// Dots, of that radius or of their own, in the order of plotting, as seen from `corner_mm` on the page, in
/// millimetres. The margins leave that rectangle of the page; none: all of it. For a part of a page, `paper`
/// is the whole, as seen from the part's corner. What reaches over it by less than a thousandth of a
/// millimetre, which is as much as files round to, is within. A million take a fraction of a second.
Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins = {},
                    glm::dvec2 corner_mm = glm::dvec2(0), const std::optional<Rectangle<double>>& paper = {});

/// How a drawing's dots come onto the paper.
enum class DotsAs {
    printed,  // pixels, or what a printer fills
    rings,    // a plotter follows the outlines of circles
    touches,  // the pen goes down and up
    shapes,   // drawn with the pen's line
    lines,    // from dot to dot
    listed,   // not at all: a table
};

/// How far the ink of dots reaches.
struct InkedDot {
    DotsAs as = DotsAs::printed;
    double radius_mm = 0;             // of dots that have none of their own
    double stroke_width_mm = 0;       // of the pen that touches, or draws shapes or lines
    std::vector<double> widths_mm{};  // of each pen, where several have widths of their own

    double reach_mm(double own_radius_mm, int pen) const;
    bool operator==(const InkedDot&) const = default;
};

/// All dots of a stream, each as large as the disc that its ink lies in: `radius` is left empty where all are
/// alike, and InkedDot::reach_mm() is theirs.
Dots inked_dots(const DotStream& dots, const InkedDot& inked, const PageSize& page);

}  // namespace dapple
