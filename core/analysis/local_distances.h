#pragma once
// How far apart dots keep in a picture, where they lie near each other in the dark and far apart in the
// light.

#include <glm/vec2.hpp>
#include <span>

#include "core/image/density.h"

namespace dapple {

/// Distances to the nearest dot, each over the largest that all dots could have at the density where the dot
/// lies, sqrt(2 / (sqrt(3) n)) for n dots on an area of 1: a hexagonal lattice has 1.
struct LocalDistances {
    double p1 = 0;  // 1st percentile: sorted value at place (count - 1) / 100, interpolated
    double mean = 0;
    std::size_t count = 0;  // of dots judged
};

/// Dots that density 1 would put on an area of 1, when there are so many in all.
double dots_at_full_density(const Density& density, std::size_t count);

/// `full` is dots_at_full_density() or, for placed dots, kDotsPerScale * scale. Two sorts of dots are left
/// out: those where the density is below 1 %, whose distances chance decides, and those nearer to the page's
/// edge than a mean spacing, the root of the page's area over the number of dots, which have neighbours on
/// one side only. All 0 if none is left. Dots lie on the page.
LocalDistances local_distances(std::span<const glm::dvec2> dots, const Density& density, double full);

}  // namespace dapple
