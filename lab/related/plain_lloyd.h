#pragma once
// Lloyd's method (S. P. Lloyd, "Least Squares Quantization in PCM", 1957, printed 1982): each dot goes to the
// centroid of its Voronoi cell, again and again. On pictures it is weighted Voronoi stippling (A. Secord,
// "Weighted Voronoi Stippling", 2002), the peer that drawings are measured against.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/density.h"
#include "lab/related/plain_voronoi.h"
#include "lab/related/wanted.h"

namespace dapple {

/// Independent dots with that density (importance sampling by rejection), the same on every machine. Throws
/// std::runtime_error if the density is 0 everywhere.
std::vector<glm::dvec2> random_dots(const Density& density, std::size_t count, std::uint64_t seed);

/// Moves every dot to the weighted centroid of its Voronoi cell within the page: see weighted_cells(). A dot
/// whose cell weighs nothing stays, and so do dots in the same place, but for one. Returns the energy before
/// the move, the integral of weight times the squared distance to the nearest dot, which no step can raise.
/// Uses all cores; the result is the same for any number.
double lloyd_step(std::vector<glm::dvec2>& dots, const Density& density, LloydWeight weight);

/// The same on the unit square, whose opposite edges meet.
void plain_lloyd_step(std::vector<glm::dvec2>& dots);

inline constexpr int kLloydSteps = 100;

/// Random dots and kLloydSteps steps; of a picture with density as the weight, as Secord has it.
PlainDots lloyd(const DotsWanted& wanted);

/// The same with the density's square as the weight, so that a picture's dots keep its density.
PlainDots lloyd_squared(const DotsWanted& wanted);

}  // namespace dapple
