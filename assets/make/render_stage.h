#pragma once

#include <cstdint>
#include <vector>

#include "assets/make/scene.h"

namespace dapple::make {

struct Quality {
    int size = 1024;           ///< pixels along each side
    int samples_per_side = 7;  ///< a pixel is the mean of the square of this many rays
};

/// The scene as 8-bit sRGB grey, row by row from the top. Light comes from the lamp, from a dim room, and
/// once from the other surfaces. The same bytes at any number of threads: a pixel's rays depend on its place
/// only.
std::vector<std::uint8_t> render(const Stage& stage, const Quality& quality);

}  // namespace dapple::make
