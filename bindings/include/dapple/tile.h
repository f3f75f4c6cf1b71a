#pragma once
// The self-similar tiles that dots are placed with (Lagae & Dutré 2006).

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dapple/export.h"

namespace dapple {

/// The tiles that come with Dapple, by the names that the settings' "tile" takes; the usual one is kinds4096.
DAPPLE_API std::vector<std::string> tile_names();

/// The text of a tile file, as Stippler::set_tile() takes it: of one that comes with Dapple, or of the
/// paper's two integers, "14217,2895/16", ranked by its energy. Throws std::runtime_error if it is neither.
DAPPLE_API std::string tile_text(std::string_view name);

/// A tile's points, in a square from 0,0 to 1,1. One of several kinds has as many of each, kind after kind.
struct TilePoints {
    std::size_t kinds = 1;
    std::vector<double> x, y;
};

/// Throws std::runtime_error saying in which line the text is wrong.
DAPPLE_API TilePoints tile_points(std::string_view text);

}  // namespace dapple
