#pragma once
// The lines that someone who draws with pen and ink would take out of a photograph: contours, each one once,
// rather than texture.

#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// The middle of a line. Lengths are in units of the picture's longer side, from its upper left corner, x to
/// the right and y down.
struct InkLine {
    std::vector<glm::dvec2> points;  // two or more; a closed one's last is its first
    std::vector<float> widths;       // at each point: from kHairWidth to kBoldWidth, less towards free ends
    float strength = 0;              // 0..1, how much it stands out
    bool light = false;              // a line of light: paper, from which dots keep away

    bool closed() const { return points.front() == points.back(); }
};

inline constexpr float kHairWidth = 0.0009f, kBoldWidth = 0.0045f;

/// All lines of a picture of linear light, the strongest first; none is weaker than 0.05. Whoever draws takes
/// those with at least some strength: half of it shows what has a shape, less brings in detail.
///
/// They are where local energy is highest across the flow (line_field.h), at two scales, about 1/500 of the
/// longer side and 1/220 where the finer one has found none; traced along the flow from the strongest place
/// on, down to where they no longer stand out (hysteresis, Canny 1986). Contrast that stands out and length
/// make the strength. The picture is reduced to 640..1,280 pixels along its longer side, if it has more.
std::vector<InkLine> find_lines(const Grid<float>& light);

/// The parts of a line whose points are kept, as it is asked for points close to each other; those of very
/// few are left out. They end with their full width.
using KeepsPoint = std::function<bool(const InkLine& line, std::size_t point)>;
std::vector<InkLine> pieces_of(const InkLine& line, const KeepsPoint& keeps);

/// Leaves out points without which the line's edges, or its middle if `widths` is empty, move by 1/10,000 or
/// less (Douglas & Peucker 1973). The first and the last stay.
void simplify(std::vector<glm::dvec2>& points, std::vector<float>& widths);

/// A cubic Bezier curve: from its first point to its last, the others its handles.
using Cubic = std::array<glm::dvec2, 4>;

/// A curve from each point to the next, which go on in the same direction (Catmull & Rom 1974, for unequal
/// distances); closed, if the last point is the first. Where a line turns by over 60 degrees it has a corner.
/// Needs two points or more, no two alike beside each other.
std::vector<Cubic> smooth_curve(std::span<const glm::dvec2> points);

/// The line with more points, on that curve, and widths between those it has, if it has any.
InkLine flattened(const InkLine& line);

}  // namespace dapple
