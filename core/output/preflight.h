#pragma once
// What a pen plotter will make of a drawing, told before it is plotted.

#include <cstdint>
#include <optional>

#include "core/image/rectangle.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"

namespace dapple {

/// Path ends nearer than this, in millimetres, are joined: the pen stays down between the two dots.
inline constexpr double kSaxiJoins = 0.5;
inline constexpr double kAxiDrawJoins = 0.152;

struct Preflight {
    double pen_up_m = 0;                 // the pen's way from dot to dot, in the order given, in metres
    double nearest_mm = 0;               // smallest distance between two dots; infinite if there are not two
    std::uint64_t nearer_than_saxi = 0;  // dots with another one nearer than kSaxiJoins
    std::uint64_t nearer_than_axidraw = 0;
    std::uint64_t overlapping = 0;      // dots that reach into others; of unequal radii into near ones
    double rings_m = 0;                 // all dots' outlines, in metres: what a plotter traces of circles
    std::uint64_t over_edge = 0;        // dots of that radius that reach over the page's edge
    std::uint64_t outside_margins = 0;  // dots with a part outside of what the margins leave

    bool operator==(const Preflight&) const = default;
};

/// Dots, of that radius or of their own, as seen from the page's corner, in the order of plotting. The
/// margins leave that rectangle, in millimetres; none: all of the page. What reaches over it by less than a
/// thousandth of a millimetre, which is as much as files round to, is within. A million take a fraction of a
/// second.
Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins = {});

}  // namespace dapple
