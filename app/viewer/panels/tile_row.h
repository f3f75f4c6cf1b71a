#pragma once
// The row that chooses a tile.

#include <functional>
#include <span>
#include <string>

namespace dapple {

/// What a row offers.
struct TileList {
    std::span<const std::string> names;    // for tile_named()
    std::function<void()> open_file = {};  // asks for another tile's file; none: the row does not offer it
};

/// A tile to choose from a list. Files stand there by their names without folders, or by their whole paths
/// where two have the same name; a tile that is not in the list is shown below it. Arrows choose tiles but
/// never ask for a file. True when another was chosen.
bool tile_row(const char* label, std::string& tile, const TileList& list, const char* tip);

}  // namespace dapple
