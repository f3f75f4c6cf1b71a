#pragma once
// Polylines with fewer points, and smooth curves through them.

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace dapple {

/// Leaves out points that lie within `tolerance` of the line between those that are left, and what belongs to
/// them in `widths`, if that is not empty (Douglas & Peucker 1973). The first and the last stay.
void simplify(std::vector<glm::dvec2>& points, std::vector<float>& widths, double tolerance);

/// A cubic Bezier curve: from its first point to its last, the others its handles.
using Cubic = std::array<glm::dvec2, 4>;

/// A curve from each point to the next, which go on in the same direction (Catmull & Rom 1974, for unequal
/// distances); closed, if the last point is the first. Where a line turns by over 60 degrees it has a corner.
/// Needs two points or more, no two alike beside each other.
std::vector<Cubic> smooth_curve(std::span<const glm::dvec2> points);

}  // namespace dapple
