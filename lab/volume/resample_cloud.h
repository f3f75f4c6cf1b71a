#pragma once
// A point cloud, as scanners make them, thinned to so many even points of its own.

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace dapple {

/// The numbers of exactly `count` of the cloud's points, rising, that keep as far from each other as they
/// can, however densely each part of the cloud was scanned: each the furthest from those before it (Gonzalez
/// 1985), and then, some times over, each taken away and put where it is furthest from all others (Schlömer,
/// Heck and Deussen 2011, "Farthest-point optimized point sets with maximized minimum distance"). Throws
/// std::runtime_error if the cloud has fewer distinct points, or count is 0.
std::vector<std::size_t> even_subset(std::span<const glm::dvec3> cloud, std::size_t count);

}  // namespace dapple
