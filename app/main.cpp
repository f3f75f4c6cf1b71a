// dapple: stipples pictures, in a window and on the command line.

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/commands/commands.h"
#include "app/viewer/viewer.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"

namespace {

// What the laboratory's program does, by the words that this one knew it under.
std::optional<std::string> moved_to_laboratory(std::span<char* const> words) {
    const std::string_view first = words.empty() ? "" : words[0], second = words.size() < 2 ? "" : words[1];
    const bool of_tiles =
        first == "tile" && (second == "rules" || second == "search" || second == "rank" || second == "check");
    const bool studies =
        first == "analyse" || first == "compare" || first == "reproduce" || first == "volume";
    if (!of_tiles && !studies) return std::nullopt;
    std::error_code none;
    if (studies && std::filesystem::exists(first, none)) return std::nullopt;  // a picture of that name
    const std::string command = std::string(first) + (of_tiles ? " " + std::string(second) : "");
    return "the command " + command + " is in dapple-lab: dapple-lab " + command + " --help";
}

}  // namespace

int main(int argc, char** argv) {
    if (const auto sentence = moved_to_laboratory(std::span(argv, argc).subspan(argc > 0 ? 1 : 0))) {
        std::fprintf(stderr, "dapple: %s\n", sentence->c_str());
        return 2;
    }
    CLI::App program{"Stippling: draws pictures with dots, live in a window or into files.", "dapple"};
    program.set_version_flag("--version", "dapple " DAPPLE_VERSION, "Show the version");
    program.footer(
        "Without a command, a window opens with the picture (the built-in sample without one).\n"
        "For more, see dapple COMMAND --help.\n"
        "Exit status: 0 if all was done, 1 if something failed, 2 if the command line is wrong.\n\n"
        "Examples:\n"
        "  dapple cat.jpg                               open it in the window\n"
        "  dapple cat.jpg --tile mine.tile              draw with your own tile\n"
        "  dapple cat.dapple                            a project: picture and settings as saved\n"
        "  dapple render cat.jpg -o cat.svg             the same as a file\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000");
    program.require_subcommand(0, 1);

    int status = 0;
    dapple::ViewerOptions viewer;
    program.add_option("image", viewer.image, "The picture to open, or a project (.dapple)")
        ->type_name("IMAGE");
    std::string window_tile = dapple::kDefaultTile;
    const CLI::Option* const tile_of_window = dapple::add_tile(program, window_tile);
    program.add_flag("--fresh", viewer.fresh,
                     "Opens the window with defaults: nothing remembered between runs (settings, recent "
                     "files, window, theme) is read or written");
    // For scripts that drive the window: nothing that help need tell.
    program.add_flag("--log-status", viewer.log_status)->group("");
    program.add_flag("--own-dialog", viewer.own_dialog)->group("");
    const auto show_map = [&](const dapple::ShownMap& map) {
        dapple::LightsSettings settings;
        settings.request = map.request;
        settings.tile = map.tile;
        settings.stops = map.stops;
        settings.turn_degrees = map.turn_degrees;
        status = dapple::run_viewer(dapple::LightViewerOptions{map.map, settings, viewer.log_status,
                                                               viewer.fresh, viewer.own_dialog});
    };
    const std::array commands{
        dapple::add_render_command(program),           dapple::add_record_command(program),
        dapple::add_lights_command(program, show_map), dapple::add_tile_command(program),
        dapple::add_test_sheet_command(program),       dapple::add_mask_command(program)};
    dapple::add_presets_command(program);

    program.callback([&] {
        if (!program.get_subcommands().empty()) return;
        if (tile_of_window->count() > 0) viewer.tile = window_tile;
        status = dapple::run_viewer(viewer);
    });
    const auto check_tile = [&] {
        if (tile_of_window->count() > 0 && !program.get_subcommands().empty())
            throw CLI::ValidationError("--tile",
                                       "applies to the window; put a command's options after its name");
    };
    return dapple::run_program(program, argc, argv, status, check_tile);
}
