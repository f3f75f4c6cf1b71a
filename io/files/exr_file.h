#pragma once
// OpenEXR into a stream: a grid of floats.

#include <ostream>

#include "core/image/grid.h"

namespace dapple {

/// The channel Y, which is grey. Not compressed.
void write_exr(std::ostream& out, const Grid<float>& values);

}  // namespace dapple
