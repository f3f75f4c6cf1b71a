// dapple tile: the built-in tiles, and a tile drawn.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "core/tile/ranking.h"
#include "core/tile/tile.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/reports/tile_figure.h"

namespace dapple {

class TileCommand {
 public:
    explicit TileCommand(CLI::App& program);

 private:
    void add_list(CLI::App& parent);
    void add_show(CLI::App& parent);

    std::string name_;  // TILE
    std::filesystem::path output_;
    std::optional<RankingMethod> ranking_;  // none: the tile's own
};

namespace {

void list_tiles(std::ostream& out) {
    out << fmt::format("{:<14} {:>5}  {:>6}  {:<8}  {}\n", "name", "kinds", "points", "rule", "");
    for (const BuiltInTile& built_in : built_in_tiles()) {
        const Tile tile = load_tile(std::string(built_in.name)).tile;
        out << fmt::format("{:<14} {:>5}  {:>6}  {:<8}  {}\n", built_in.name, tile.kinds(), tile.size(),
                           text_of(tile.rule), built_in.about);
    }
}

}  // namespace

TileCommand::TileCommand(CLI::App& program) {
    CLI::App* const tile = program.add_subcommand("tile", "List and show tiles");
    tile->require_subcommand(1);
    tile->footer(
        "TILE is a built-in tile's name, a tile file, or the paper's two integers.\n"
        "dapple-lab tile searches for tiles, ranks and checks them.\n\n"
        "Examples:\n"
        "  dapple tile show paper16 --ranking paper -o paper16.svg\n"
        "                                                     its points, copies and ranks, as in the paper\n"
        "  dapple render cat.jpg -o cat.svg --tile mine.tile");
    add_list(*tile);
    add_show(*tile);
}

void TileCommand::add_list(CLI::App& parent) {
    parent.add_subcommand("list", "The built-in tiles")->callback([] { list_tiles(std::cout); });
}

void TileCommand::add_show(CLI::App& parent) {
    CLI::App* const command =
        parent.add_subcommand("show", "Draw a tile's points, self-similarity and ranks");
    command
        ->add_option("tile", name_,
                     "A built-in tile's name, a tile file, or two integers as in 14217,2895/16")
        ->type_name("TILE")
        ->required();
    command->add_option("-o,--output", output_, "The drawing; its name ends in .svg")
        ->type_name("FILE")
        ->required();
    add_ranking(*command, ranking_);
    command->callback([this, command] {
        if (ending_of(output_) != ".svg")
            throw CLI::ValidationError("--output", output_.string() + " does not end in .svg");
        check_apart(*command, {"--output"}, {{output_, "the figure"}});
        check_can_save(output_);
        StoredTile stored = load_tile(name_);
        if (ranking_) stored = ranked(std::move(stored.tile), *ranking_);
        save_atomically(output_, [&](std::ostream& out) { write_tile_figure(out, stored); });
    });
}

Command add_tile_command(CLI::App& program) {
    return std::make_shared<TileCommand>(program);
}

}  // namespace dapple
