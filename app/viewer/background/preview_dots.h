#pragma once
// Some of a drawing's dots in place of all, for where there is no time for all of them.

#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "core/image/ink.h"
#include "core/image/rectangle.h"
#include "core/placing/dots.h"

namespace dapple {

/// The dots that are to be previewed.
struct DotsInFull {
    const DotPieces& dots;
    std::span<const DotBlock> blocks = {};      // dot_blocks() of them,
    std::span<const std::size_t> in_view = {};  // of which these are looked at
    std::span<const glm::u8vec4> colours = {};  // one a dot, or none
    Rectangle<double> view{{0, 0}, {0, 0}};     // what is seen, page units from the window's corner
    double radius = 0;                          // page units, of dots that have none of their own
    InkedDots ink = {};                         // how they cover the paper where
    double full_load = 0;                       // their density is 1
};

struct PreviewDots {
    DotPieces dots;  // each has a radius
    std::vector<DotBlock> blocks;
    std::vector<glm::u8vec4> colours;  // one a dot, or none
};

/// About one dot in `every`, so much larger that all tones are as dark. They are those that appear first,
/// which are the lighter drawing: relaxing moves dots by less than it has between them, so that it is about
/// as even. Of dots without Dots::critical every n-th.
PreviewDots preview_dots(const DotsInFull& all, double every);

}  // namespace dapple
