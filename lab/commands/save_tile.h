#pragma once
// A tile as a file, as the commands that find tiles and rank them save it.

#include <filesystem>
#include <string>
#include <vector>

#include "core/tile/tile_file.h"

namespace dapple {

/// Saves a tile as a file with its criteria as comments, `more` last. Throws as save_atomically().
void save_tile(const std::filesystem::path& file, const StoredTile& tile,
               const std::vector<std::string>& more = {});

}  // namespace dapple
