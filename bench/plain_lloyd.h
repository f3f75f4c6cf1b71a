#pragma once
// The peer that pictures are measured against: weighted Voronoi stippling (Secord 2002), random dots and then
// plain steps of Lloyd's method, each dot to its cell's weighted centroid.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/density.h"

namespace dapple {

/// Independent dots with that density (importance sampling by rejection), the same on every machine. Throws
/// std::runtime_error if the density is 0 everywhere.
std::vector<glm::dvec2> random_dots(const Density& density, std::size_t count, std::uint64_t seed);

enum class LloydWeight {
    density,          // as Secord has it; dots then tend to the density's square root
    density_squared,  // dots tend to the density
};

/// Moves every dot to the weighted centroid of its Voronoi cell within the page. Cells are exact polygons;
/// the weight is integrated over triangles no longer than a pixel of the density, exactly where it is
/// constant. A dot whose cell weighs nothing stays, and so do dots in the same place, but for one. Returns
/// the energy before the move, the integral of weight times the squared distance to the nearest dot, which no
/// step can raise. Uses all cores; the result is the same for any number.
double lloyd_step(std::vector<glm::dvec2>& dots, const Density& density, LloydWeight weight);

}  // namespace dapple
