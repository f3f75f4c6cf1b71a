#pragma once
// A tile as the window shows it.

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/placing/stipple.h"

namespace dapple {

struct TileView {
    std::string name;
    Rule rule;  // how the tile is turned in each of its quadrants
    std::vector<glm::vec2>
        points;  // in the unit square, y down, in the order in which they appear; of kind 0
    /// The same for those that its children add to it, after which all of their points are there; Figure 8
    /// has no such order, and several kinds have several.
    std::vector<glm::vec2> newborn = {};
    NextKinds next_kind = NextKinds(1);
};

/// The tile's own points in the order that the placer gives them; Figure 8 has one of its own.
TileView view_of(std::string name, RankedTile& tile, PlacerKind placer);

}  // namespace dapple
