#pragma once
// The coverage of a grid of pixels by dots, for measuring: the grid may have any size.

#include <glm/vec2.hpp>
#include <span>

#include "core/image/grid.h"

namespace dapple {

struct PixelPage {
    int width = 0, height = 0;   // pixels
    double pixels_per_unit = 0;  // of the dots' positions
};

/// The share of each pixel that discs of that radius, in units, cover.
Grid<float> raster_of_dots(std::span<const glm::dvec2> dots, double radius, const PixelPage& page);

}  // namespace dapple
