#pragma once
// A page's density, with its tiles placed so that the page's edges lie off their borders.

#include "core/image/density.h"
#include "core/image/grid.h"

namespace dapple {

/// Where tiles begin on a page of that size, for its edges to lie off the borders of tiles: a sixth of a
/// tile's side and more, at the first eight levels. Dots keep away from borders, and would stand in rows
/// along edges.
glm::dvec2 corner_off_edges(int width, int height);

/// The density whose tiles begin there. Throws as Density's constructor does.
Density page_density(Grid<float> values, Reading reading = Reading::bilinear);

/// The same density of cells, each as so many pixels across and down.
Density in_finer_cells(const Density& cells, int times);

}  // namespace dapple
