#pragma once
// Which tiles can lie beside a tile when children are oriented by a rule, and of which kinds.

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {

/// A tile that touches another one of the same size, seen from that one's frame.
struct Neighbour {
    glm::ivec2 offset;        // in tiles, -1..1 on each axis, not (0, 0)
    Orientation orientation;  // relative to the frame
    double probability = 0;  // how often, of all at that offset of one kind in a large subdivision; sums to 1
    std::uint16_t of = 0;    // the kind whose neighbour it is
    std::uint16_t kind = 0;  // its own
};

/// All neighbours that occur, by the kind whose they are, offset, kind, then orientation. Found as a
/// fixpoint: the four siblings touch each other, and where two tiles touch so do some of their children. The
/// identity rule and one kind give eight, the torus.
std::vector<Neighbour> legal_neighbours(const Rule& rule, const NextKinds& next_kind = NextKinds(1));

/// For each kind of a tile the legal neighbours that are of it: where else its points are seen.
std::vector<std::vector<Neighbour>> copies_of_kinds(const Tile& tile);

/// The position, in the frame's tile units, of point p of a neighbour.
glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p);

/// Calls visit(place, probability, kind) for a point of a tile of some kind and those of its copies that lie
/// within a radius of another tile, with that one's kind; `copies` is its kind's of copies_of_kinds().
template <class Visit>
void for_copies(glm::dvec2 p, std::size_t kind, const std::vector<Neighbour>& copies, double radius,
                Visit visit) {
    visit(p, 1.0, kind);
    if (p.x > radius && p.y > radius && p.x < 1 - radius && p.y < 1 - radius) return;
    for (const Neighbour& n : copies) {
        const glm::dvec2 copy = position_in(n, p);
        const glm::dvec2 d = copy - glm::dvec2(std::clamp(copy.x, 0.0, 1.0), std::clamp(copy.y, 0.0, 1.0));
        if (d.x * d.x + d.y * d.y <= radius * radius) visit(copy, n.probability, std::size_t{n.of});
    }
}

}  // namespace dapple
