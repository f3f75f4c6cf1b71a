#pragma once
// Seams: bare paper that lines up along the borders of tiles, where black shows it most.

#include <glm/vec2.hpp>
#include <span>

namespace dapple {

/// The share of bare paper in strips around borders over that of the whole page; 1: no seam. One for the
/// inner borders of tiles of each side, those of larger tiles included.
struct Seams {
    double of_halves = 0, of_quarters = 0, of_eighths = 0;
    double bare = 0;  // the page's share of bare paper

    double worst() const;
};

/// The seams of dots for even black on the unit square, drawn with radius sqrt(load / (pi count)), so that
/// their area together is `load` pages. A strip is two thirds of a mean spacing wide, half of it on each side
/// of the border. A spacing along the page's edge, beyond which there are no dots, is left out of all shares.
/// All 0 where no paper is bare.
Seams seams(std::span<const glm::dvec2> dots, double load);

}  // namespace dapple
