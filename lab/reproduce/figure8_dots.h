#pragma once
// Figure 8 with the paper's ranks, asked for a number of dots.

#include <string>

#include "core/image/density.h"
#include "core/placing/stipple.h"

namespace dapple {

struct Figure8Drawing {
    Figure8Result placed;
    double place_ms = 0;  // wall time of the last placing
};

/// The tile of Appendix A at the scale at which Figure 8 emits so many dots, duplicates included, or a few
/// more where several come at one scale. Throws std::runtime_error if the picture has not so many.
Figure8Drawing figure8_drawing(const Density& density, std::size_t emitted);

/// "28,291 dots, 6,480 of them a second time, placed in 4.0 ms".
std::string in_words(const Figure8Drawing& drawing);

}  // namespace dapple
