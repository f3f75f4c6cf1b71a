#pragma once
// What each side of the split view shows, under it.

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace dapple {

/// What stands under one side of the split view: what it is drawn with, and what that came to.
struct SideCaption {
    std::string title;
    std::vector<std::string> info;  // two lines of them
};

/// The height of the strip that they need.
float side_captions_height();

/// Draws both into a strip below the canvas, each in the middle of its side of the divider at `share` of the
/// width. On a side too narrow for it a line ends in dots.
void draw_side_captions(const std::array<SideCaption, 2>& captions, float share, glm::vec2 corner,
                        glm::vec2 size);

}  // namespace dapple
