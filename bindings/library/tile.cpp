#include "dapple/tile.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bindings/library/state.h"
#include "core/tile/tile_file.h"

namespace dapple {

StoredTile stored_tile(std::string_view name) {
    if (std::optional<StoredTile> built_in = built_in_tile(name)) return *std::move(built_in);
    if (looks_like_tile_integers(name)) return ranked(parse_tile_integers(name), RankingMethod::energy);
    throw std::runtime_error(fmt::format(
        "{} is no tile that comes with Dapple; read a tile's file, and give its text to set_tile()", name));
}

std::vector<std::string> tile_names() {
    const auto names = built_in_tile_names();
    return {names.begin(), names.end()};
}

std::string tile_text(std::string_view name) {
    return write_tile(stored_tile(name));
}

TilePoints tile_points(std::string_view text) {
    const Tile tile = read_tile(text).tile;
    TilePoints result{tile.kinds(), {}, {}};
    for (const BinaryPoint& point : tile.points) {
        result.x.push_back(to_unit_square(point).x);
        result.y.push_back(to_unit_square(point).y);
    }
    return result;
}

}  // namespace dapple
