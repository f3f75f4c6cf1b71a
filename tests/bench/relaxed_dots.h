#pragma once
// Dapple's dots as they are measured: in true light, placed and relaxed so many steps.

#include <cstddef>
#include <ctime>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "core/drawing/pipeline.h"

namespace dapple {

struct RelaxedDots {
    std::vector<glm::dvec2> dots{};
    std::shared_ptr<const Density> density;
    double scale = 0;   // kDotsPerScale * scale * density is the number of dots on an area of 1
    double radius = 0;  // page units, that the program draws them with
    double ms = 0;      // the processor's, of all threads together, for placing and relaxing
};

/// The processor's time of all threads together, which other work on the machine disturbs little.
double processor_ms_since(std::clock_t start);

/// Exactly `count` dots after `steps` steps of relaxation (0: as placed), by all cores. Throws
/// std::runtime_error where the pipeline does.
RelaxedDots relaxed_dots(Pipeline& pipeline, std::size_t count, int steps);

}  // namespace dapple
