#pragma once
// A page on which someone sees what their pens really do: how much wider than its line a pen's dots are, and
// what tone they make.
//
//      1 CYAN 0.3 MM                                . . . . . . . . . .      single dots
//      :::        :::        :::        :::                                  pairs, three alike
//      0          0.02       0.04       0.06  ...                            so far from edge to edge
//      [] 10     [] 25      [] 50      [] 75     [] 90     [] 100            tones, in per cent
//
// The dots of a pair lie one above the other, as far apart as the pen is wide and the gap beneath says. Ink
// that spreads closes the first gaps: the last one that it closes is the pen's dot gain. Dots of the tones
// are taken to be as wide as the pen and the gain that it already has.

#include <cstdint>
#include <span>
#include <vector>

#include "core/pens/pen.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// What a test sheet has room for.
inline constexpr double kFinestTestedMm = 0.02, kWidestTestedMm = 2;

struct TestSheet {
    Strokes strokes;         // one pen's after the other's; a dot is a touch
    std::uint64_t dots = 0;  // among them
};

/// Pens in the order of their numbers. Throws std::runtime_error saying what to do if one has no width or too
/// large a one, or if the page is too small.
TestSheet test_sheet(std::span<const Pen> pens, const PageSize& page);

}  // namespace dapple
