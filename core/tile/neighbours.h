#pragma once
// Which tiles can lie beside a tile when children are oriented by a rule.

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {

/// A tile that touches another one of the same size, seen from that one's frame.
struct Neighbour {
    glm::ivec2 offset;        // in tiles, -1..1 on each axis, not (0, 0)
    Orientation orientation;  // relative to the frame
    double probability =
        0;  // how often, of all the neighbours at that offset in a large subdivision; sums to 1
};

/// All neighbours that the rule lets occur, by offset, then orientation. Found as a fixpoint: the four
/// siblings touch each other, and where two tiles touch so do some of their children. The identity rule gives
/// eight, the torus.
std::vector<Neighbour> legal_neighbours(const Rule& rule);

/// The position, in the frame's tile units, of point p of a neighbour.
glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p);

/// Calls visit(place, probability) for a point of the tile and those of its copies in neighbouring tiles that
/// lie within a radius of the tile.
template <class Visit>
void for_copies(glm::dvec2 p, const std::vector<Neighbour>& neighbours, double radius, Visit visit) {
    visit(p, 1.0);
    if (p.x > radius && p.y > radius && p.x < 1 - radius && p.y < 1 - radius) return;
    for (const Neighbour& n : neighbours) {
        const glm::dvec2 copy = position_in(n, p);
        const glm::dvec2 d = copy - glm::dvec2(std::clamp(copy.x, 0.0, 1.0), std::clamp(copy.y, 0.0, 1.0));
        if (d.x * d.x + d.y * d.y <= radius * radius) visit(copy, n.probability);
    }
}

}  // namespace dapple
