#pragma once
// The tiles that come with Dapple, and which names are theirs.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/tile/tile_file.h"

namespace dapple {

struct BuiltInTile {
    const char* name;
    const char* about;  // one line
};

/// In the order in which a list shows them.
const std::vector<BuiltInTile>& built_in_tiles();

/// The names of built_in_tiles(), for lists to choose from.
std::span<const char* const> built_in_tile_names();

/// With the ranking that it is stored with. Nothing if no built-in tile has that name.
std::optional<StoredTile> built_in_tile(std::string_view name);

/// Whether a name is the paper's two integers: "14217,2895/16", which parse_tile_integers() reads.
bool looks_like_tile_integers(std::string_view name);

/// Whether it is neither a built-in tile's nor integers: then it is that of a file.
bool is_tile_file_name(std::string_view name);

}  // namespace dapple
