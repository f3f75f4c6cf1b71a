#pragma once
// A drawing's dots in blocks that lie together on the page, so that who draws a part of it need not look at
// all of them.

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/placing/dots.h"

namespace dapple {

inline constexpr std::size_t kDotsPerBlock = 4096;

/// Dots that follow each other in a piece.
struct DotBlock {
    std::size_t piece = 0, first = 0;  // where they begin in it
    std::size_t index = 0;             // the first one's among all dots
    std::size_t count = 0;             // at least 1, at most kDotsPerBlock
    glm::vec2 low{0}, high{0};         // the box of their centres, page units from the window's corner
    double radii = 0;                  // their sum, page units; 0 if they have none of their own
    float largest_radius = 0;
};

/// All dots, in their order. Ten million take some hundredths of a second.
std::vector<DotBlock> dot_blocks(const DotPieces& dots);

}  // namespace dapple
