#pragma once
// The page that a picture fills, and parts of it on sheets of their own.

#include <limits>
#include <span>

#include "core/image/density.h"
#include "core/image/grid.h"
#include "core/placing/dots.h"
#include "core/placing/placer.h"

namespace dapple {

// A page's density, with its tiles placed so that the page's edges lie off their borders.

/// Where tiles begin on a page of that size, for its edges to lie off the borders of tiles: a sixth of a
/// tile's side and more, at the first eight levels. Dots keep away from borders, and would stand in rows
/// along edges.
glm::dvec2 corner_off_edges(int width, int height);

/// The density whose tiles begin there. Throws as Density's constructor does.
Density page_density(Grid<float> values, Reading reading = Reading::bilinear);

/// The same density of cells, each as so many pixels across and down.
Density in_finer_cells(const Density& cells, int times);

/// How large a page is, in millimetres.
struct PageSize {
    double width_mm = 0, height_mm = 0;
    double mm_per_page_unit = 0;  // the longer side of the whole page
};

/// Where a part of the page begins and ends along one side, in page units: positions in [first, end) are on
/// it. What lies on the page's own edges is on the outermost parts.
struct PageSpan {
    float first = -1, end = std::numeric_limits<float>::max();
    double offset = 0;  // of the part's corner

    bool operator==(const PageSpan&) const = default;
};

/// A rectangle of the page; the whole of it, unless said otherwise.
struct PagePart {
    PageSpan across, down;

    bool operator==(const PagePart&) const = default;
};

/// The part and what lies within so many page units around it, still seen from the part's corner: where the
/// centres lie of dots that reach onto it.
PagePart widened(const PagePart& part, double by);

/// The window that all dots of the part lie in: a little larger, since a part is cut by rounded positions
/// and a window by exact ones.
PageWindow window_around(const PagePart& part);

/// Leaves the dots whose centres lie on the part, seen from its corner. Parts with common edges share the
/// dots out without a lost or a doubled one.
void cut_to(const PagePart& part, Dots& dots);

/// The tiles as seen from the part's corner. None is left out: most lie partly beyond its edges.
void move_to(const PagePart& part, std::span<PlacedTile> tiles);

}  // namespace dapple
