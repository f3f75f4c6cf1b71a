#pragma once
// Sobol' points in two dimensions (1967), and Owen's scrambling (1995), which makes them random and keeps how
// evenly they lie: of the first 2^m, each of 2^m equal boxes has exactly one, however long and wide the
// boxes.

#include <cstdint>
#include <glm/vec2.hpp>

namespace dapple {

/// The point of that number, in [0, 1) and whole 2^-32.
glm::dvec2 sobol_point(std::uint32_t index);

/// Of such points, all of a set with the same seed.
glm::dvec2 scrambled(glm::dvec2 point, std::uint64_t seed);

}  // namespace dapple
