#pragma once
// dapple-lab tile: the tile workshop - rules, search, rank, check.

#include <filesystem>
#include <ostream>
#include <string>

#include "core/text/names.h"
#include "lab/commands/tile_search.h"

namespace CLI {
class App;
}

namespace dapple {

/// How `tile rank` ranks points.
enum class NewRanking { paper, farthest, energy, searched, stored };
constexpr auto names_of(NewRanking) {
    return names("paper", "farthest", "energy", "searched", "stored");
}

enum class CheckFormat { text, json };

/// Which tiles `tile check` shows the words of: those whose words are few enough to look at, or all.
enum class ShownWords { of_small_tiles, of_all };

/// Writes all criteria of a tile. As text with its words, if they are shown; as JSON always with them.
void check_tile(std::ostream& out, const std::string& name, CheckFormat format,
                ShownWords words = ShownWords::of_small_tiles);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class LabTileCommand {
 public:
    explicit LabTileCommand(CLI::App& program);
    LabTileCommand(const LabTileCommand&) = delete;
    LabTileCommand& operator=(const LabTileCommand&) = delete;

 private:
    void add_rules(CLI::App& parent);
    void add_search(CLI::App& parent);
    void add_rank(CLI::App& parent);
    void add_check(CLI::App& parent);

    std::string name_;  // TILE
    std::filesystem::path output_;
    NewRanking new_ranking_ = NewRanking::energy;
    CheckFormat format_ = CheckFormat::text;
    ShownWords words_ = ShownWords::of_small_tiles;
    int rules_ = 20;  // listed
    TileSearchOptions search_;
};

}  // namespace dapple
