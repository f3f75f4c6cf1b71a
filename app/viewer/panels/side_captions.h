#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>

namespace dapple {

/// What stands under one side of the split view: what it is drawn with, and what that came to.
struct SideCaption {
    std::string title, facts;
};

/// Of the strip that they need.
float side_captions_height();

/// Draws both into a strip below the canvas, each in the middle of its side of the divider at `share` of the
/// width. On a side too narrow for it a caption is cut at the divider.
void draw_side_captions(const std::array<SideCaption, 2>& captions, float share, glm::vec2 corner,
                        glm::vec2 size);

}  // namespace dapple
