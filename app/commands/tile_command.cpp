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

namespace {

struct ShowOptions {
    std::string name;  // TILE
    std::filesystem::path output;
    std::optional<RankingMethod> ranking;  // none: the tile's own
};

void list_tiles(std::ostream& out) {
    out << fmt::format("{:<14} {:>5}  {:>6}  {:<8}  {}\n", "name", "kinds", "points", "rule", "");
    for (const BuiltInTile& built_in : built_in_tiles()) {
        const Tile tile = load_tile(std::string(built_in.name)).tile;
        out << fmt::format("{:<14} {:>5}  {:>6}  {:<8}  {}\n", built_in.name, tile.kinds(), tile.size(),
                           text_of(tile.rule), built_in.about);
    }
}

}  // namespace

Command add_tile_command(CLI::App& program) {
    const auto kept = std::make_shared<ShowOptions>();
    ShowOptions& options = *kept;
    CLI::App* const tile = program.add_subcommand("tile", "List and show tiles");
    tile->require_subcommand(1);
    tile->footer(
        "TILE is a built-in tile's name, a tile file, or the paper's two integers.\n"
        "dapple-lab tile searches for tiles, ranks and checks them.\n\n"
        "Examples:\n"
        "  dapple tile show paper16 --ranking paper -o paper16.svg\n"
        "                                                     its points, copies and ranks, as in the paper\n"
        "  dapple render cat.jpg -o cat.svg --tile mine.tile");
    tile->add_subcommand("list", "The built-in tiles")->callback([] { list_tiles(std::cout); });
    CLI::App* const command = tile->add_subcommand("show", "Draw a tile's points, self-similarity and ranks");
    command
        ->add_option("tile", options.name,
                     "A built-in tile's name, a tile file, or two integers as in 14217,2895/16")
        ->type_name("TILE")
        ->required();
    command->add_option("-o,--output", options.output, "The drawing; its name ends in .svg")
        ->type_name("FILE")
        ->required();
    add_ranking(*command, options.ranking);
    command->callback([&options, command] {
        if (ending_of(options.output) != ".svg")
            throw CLI::ValidationError("--output", options.output.string() + " does not end in .svg");
        check_apart(*command, {"--output"}, {{options.output, "the figure"}});
        check_can_save(options.output);
        StoredTile stored = load_tile(options.name);
        if (options.ranking) stored = ranked(std::move(stored.tile), *options.ranking);
        save_atomically(options.output, [&](std::ostream& out) { write_tile_figure(out, stored); });
    });
    return kept;
}

}  // namespace dapple
