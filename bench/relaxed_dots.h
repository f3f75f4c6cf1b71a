#pragma once
// Dapple's dots as they are measured: placed, and relaxed so many steps.

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/stipple.h"

namespace dapple {

struct RelaxedDots {
    std::vector<glm::dvec2> dots{};
    double scale = 0;  // 16 * scale * density is the number of dots on an area of 1
    double ms = 0;     // wall time of placing and relaxing
};

/// Exactly `count` dots after `steps` steps of relaxation (0: as placed), by all cores. Throws
/// std::runtime_error where stipple() does.
RelaxedDots relaxed_dots(RankedTile& tile, const Density& density, std::size_t count, int steps);

}  // namespace dapple
