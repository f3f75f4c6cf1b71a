#pragma once
// A tile as the paper draws it (Lagae & Dutré 2006, figures 1 and 2).
//
//      +----------+  +----------+  +----------+
//      | points   |  | half-size|  | ranks    |      upper row: the tile; its copies on the quadrants, with
//      |          |  | copies   |  |          |      its own points circled where a copy's point coincides
//      +----------+  +----------+  +----------+      (over 256, black); the ranks, as numbers for up to 64
//      +------+  +------+  +------+  +------+
//      | N/4  |  | N/2  |  | 3N/4 |  | N    |        lower row: the first points of the ranking
//      +------+  +------+  +------+  +------+
//
// A tile of several kinds shows kind 0, with copies of the kinds of its children.
//
// An F in each quadrant shows how the copy there is turned. The frame is the page's: x right, y down.

#include <ostream>

#include "core/tile/tile_file.h"

namespace dapple {

/// Writes an SVG of about 200 mm by 130 mm. Its groups have the ids tile, copies, coinciding, ranks, first-1
/// .. first-4, with one circle for each point that they show (one text for each rank of a small tile).
void write_tile_figure(std::ostream& out, const StoredTile& stored);

}  // namespace dapple
