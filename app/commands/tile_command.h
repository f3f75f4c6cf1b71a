#pragma once
// dapple tile: the built-in tiles, and a tile drawn.

#include <filesystem>
#include <optional>
#include <string>

#include "core/tile/ranking.h"

namespace CLI {
class App;
}

namespace dapple {

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class TileCommand {
 public:
    explicit TileCommand(CLI::App& program);
    TileCommand(const TileCommand&) = delete;
    TileCommand& operator=(const TileCommand&) = delete;

 private:
    void add_list(CLI::App& parent);
    void add_show(CLI::App& parent);

    std::string name_;  // TILE
    std::filesystem::path output_;
    std::optional<RankingMethod> ranking_;  // none: the tile's own
};

}  // namespace dapple
