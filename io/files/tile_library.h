#pragma once
// Tiles by name.
//
// A tile is named by one of the built-in ones ("paper16"), by the paper's two integers ("14217,2895/16"), or
// by a file (core/tile/tile_file.h).

#include <filesystem>
#include <optional>
#include <string>

#include "core/placing/stipple.h"
#include "core/tile/tile_file.h"
#include "io/files/text_file.h"

namespace dapple {

/// What the name of a tile file usually ends in.
inline constexpr const char* kTileEnding = ".tile";
/// For text_of_file(): many times the size of any.
inline constexpr TextKind kTileFile{"tile", 16'000'000};
/// Whether it does, in small letters or capitals.
bool ends_as_tile(const std::filesystem::path& file);

/// A tile's name as a list shows it: of a file, the name without its folders.
std::string short_tile_name(const std::string& name);

/// The tile of that name with the ranking it is stored with; integers are ranked by energy. Throws
/// std::runtime_error if there is none, listing the names there are, or if its file is not a tile, with the
/// line that is wrong.
StoredTile load_tile(const std::string& name);

/// The same, ready for placing. If the stored ranking is not by the method given here, the tile is ranked
/// anew.
RankedTile tile_named(const std::string& name, std::optional<RankingMethod> method = {});

}  // namespace dapple
