#pragma once
// Parts of a picture so dark that pen and ink would make them solid black.

#include <glm/vec2.hpp>
#include <vector>

#include "core/image/grid.h"
#include "core/lines/ink_lines.h"

namespace dapple {

/// Places are in units of the picture's longer side, as those of InkLine are.
struct InkArea {
    /// Each closed, its last point its first, with a smooth outline, for smooth_curve(). The first is the
    /// outer one, the others are holes in it.
    std::vector<std::vector<glm::dvec2>> rings;
};

/// Where a picture of linear light, its sRGB-encoded values slightly blurred, is darker than 1 - darkness
/// (0..1; 0.9 is black to the eye): pieces with at least the area of a square with the side `least_size`.
/// What is narrower than about 1/400 of the longer side is no part of them, and specks of paper in them are
/// filled; lines of light in them that are wider stay.
std::vector<InkArea> find_blacks(const Grid<float>& light, double darkness, double least_size);

/// What of the lines lies outside the areas by more than `margin`: within it a line would follow the area's
/// outline. See pieces_of().
std::vector<InkLine> outside(const std::vector<InkLine>& lines, const std::vector<InkArea>& areas,
                             double margin);

/// How much of each pixel is covered by the areas and by lines of their widths, both widened by `gap` (>= 0,
/// in the same units) on each side: 0..1. The pixels lie over a picture of the same shape as theirs.
Grid<float> coverage(const std::vector<InkLine>& lines, const std::vector<InkArea>& areas, double gap,
                     int width, int height);

}  // namespace dapple
