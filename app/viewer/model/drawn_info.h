#pragma once
// What the panels need to know of the drawing that is shown.

#include <cstdint>

#include "core/drawing/settings.h"

namespace dapple {

/// What the drawing on screen came to: where sliders start from when the person switches between scale and
/// count, or from the automatic radius to a fixed one.
struct DrawnInfo {
    std::uint64_t dots = 0;
    double scale = 0;
    double dot_radius_mm = 0;
    std::uint64_t most_dots = kMostDots;  // that the window takes on
    Tone tone{};                          // with the values that were chosen automatically
    int steps = 0;                        // of relaxation
    int usual_steps = 0;                  // of so many dots
    PageSize page{200, 150, 200};
};

/// Where dots that are sized otherwise start from: as large as they were drawn, about.
DotSize dot_size_from(DotSizing sizing, double drawn_radius_mm);

}  // namespace dapple
