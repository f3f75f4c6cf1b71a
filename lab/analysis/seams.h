#pragma once
// A tile's seams: even black drawn with it, and the bare paper along the borders of its copies.

#include <glm/vec2.hpp>
#include <span>

#include "core/image/grid.h"
#include "core/placing/stipple.h"

namespace dapple {

// The coverage of a grid of pixels by dots, for measuring: the grid may have any size.

struct PixelPage {
    int width = 0, height = 0;   // pixels
    double pixels_per_unit = 0;  // of the dots' positions
};

/// The share of each pixel that discs of that radius, in units, cover.
Grid<float> raster_of_dots(std::span<const glm::dvec2> dots, double radius, const PixelPage& page);

// Seams: bare paper that lines up along the borders of tiles, where black shows it most.

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

/// The dots' area over the page's, at which seams of tiles are compared: about the black of a drawing.
inline constexpr double kSeamLoad = 1.6;

/// The tile's first full level of at least so many dots: N times a power of 4.
std::size_t full_level(const RankedTile& tile, std::size_t fewest_dots);

/// The seams of the first full level of 40,000 dots or more as they are placed, before any relaxation. Takes
/// about half a second.
Seams seams_on_black(RankedTile& tile);

}  // namespace dapple
