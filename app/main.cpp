// dapple: stipples pictures, in a window and on the command line.

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "app/commands/analyse.h"
#include "app/commands/compare.h"
#include "app/commands/complete.h"
#include "app/commands/lights.h"
#include "app/commands/manual.h"
#include "app/commands/mask_command.h"
#include "app/commands/options.h"
#include "app/commands/presets_command.h"
#include "app/commands/record.h"
#include "app/commands/render_command.h"
#include "app/commands/reproduce.h"
#include "app/commands/test_sheet_command.h"
#include "app/commands/tile_command.h"
#include "app/commands/volume_command.h"
#include "app/commands/wrapped_help.h"
#include "app/commands/wrong_command.h"
#include "app/signals.h"
#include "app/viewer/viewer.h"
#include "core/text/shown_text.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

// Sentences name files, whose names may be anything.
int report(std::string_view sentence, int code) {
    std::fprintf(stderr, "dapple: %s\n", dapple::shortened(dapple::printable(sentence)).c_str());
    return code;
}

// What was printed may still be on its way, to a disk that is full.
int written(int status) {
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::cout) return status;
    return report("the standard output cannot be written: " + std::generic_category().message(errno),
                  kFailed);
}

int run(CLI::App& program, int argc, char** argv, const int& status, const bool& parsed) {
    if (const auto sentence = dapple::wrong_command(program, std::span(argv, argc).subspan(argc > 0 ? 1 : 0)))
        return report(*sentence, kUsage);
    if (const auto sentence = dapple::wrong_option(program, std::span(argv, argc).subspan(argc > 0 ? 1 : 0)))
        return report(*sentence, kUsage);
    try {
        program.parse(argc, argv);
        return status;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        return report(error.what(), kUsage);
    } catch (const std::bad_alloc&) {
        return report("there is not enough memory for this; try fewer dots or a smaller picture", kFailed);
    } catch (const std::exception& error) {
        // TBB's words, and those of the standard library.
        const std::string_view what = error.what();
        const auto* const system = dynamic_cast<const std::system_error*>(&error);
        if (what.starts_with("pthread_create") ||
            (system && system->code() == std::errc::resource_unavailable_try_again))
            return report(
                "the system starts no more threads for this; allow it more memory or threads (ulimit -v, "
                "ulimit -u)",
                kFailed);
        return report(what, parsed ? kFailed : kUsage);
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program{"Stippling: pictures drawn with dots, live in a window or into files.", "dapple"};
    program.formatter(std::make_shared<dapple::WrappedHelp>());
    program.set_version_flag("--version", "dapple " DAPPLE_VERSION, "Show the version");
    program.footer(
        "Without a command, a window opens with the picture (the built-in sample without one).\n"
        "dapple COMMAND --help says more.\n"
        "Exit status: 0 if all was done, 1 if something could not be, 2 if the command line is wrong.\n\n"
        "Examples:\n"
        "  dapple cat.jpg                               look at it, move the sliders\n"
        "  dapple cat.jpg --tile mine.tile              drawn with a tile of your own\n"
        "  dapple cat.dapple                            a project: picture and settings as they were saved\n"
        "  dapple render cat.jpg -o cat.svg             the same as a file\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000");
    program.require_subcommand(0, 1);

    int status = 0;
    bool parsed = false;  // all that is wrong before is the command line
    dapple::ViewerOptions viewer;
    program.add_option("image", viewer.image, "The picture to look at, or a project (.dapple)")
        ->type_name("IMAGE");
    std::string window_tile = dapple::kDefaultTile;
    const CLI::Option* const tile_of_window = dapple::add_tile(program, window_tile);
    program.add_flag(
        "--fresh", viewer.fresh,
        "Open the window as on the first day: nothing that is remembered between runs (settings, "
        "recent files, window, theme) is read or written");
    // For scripts that drive the window: nothing that help need tell.
    program.add_flag("--log-status", viewer.log_status)->group("");
    program.add_flag("--own-dialog", viewer.own_dialog)->group("");
    const dapple::RenderCommand render(program);
    const dapple::RecordCommand record(program);
    const dapple::ReproduceCommand reproduce(program);
    const dapple::AnalyseCommand analyse(program);
    const dapple::CompareCommand compare(program);
    const dapple::LightsCommand lights(program);
    const dapple::TileCommand tile(program);
    const dapple::TestSheetCommand test_sheet(program);
    const dapple::MaskCommand mask(program);
    const dapple::VolumeCommand volume(program);
    const dapple::CompleteCommand complete(program);
    dapple::add_presets_command(program);
    dapple::add_manual_command(program);

    std::optional<dapple::ToldWhenStopped> told;
    // Before the command runs.
    program.parse_complete_callback([&] {
        if (tile_of_window->count() > 0 && !program.get_subcommands().empty())
            throw CLI::ValidationError("--tile",
                                       "belongs to the window; give the command's own after its name");
        parsed = true;
        if (!program.get_subcommands().empty()) told.emplace();
    });
    program.callback([&] {
        if (const dapple::LightsOptions* map = lights.window()) {
            dapple::LightsSettings settings;
            settings.request = map->request;
            settings.tile = map->tile;
            settings.stops = map->exposure.value_or(0);
            settings.turn_degrees = map->rotation_degrees;
            status = dapple::run_viewer(dapple::LightViewerOptions{map->map, settings, viewer.log_status,
                                                                   viewer.fresh, viewer.own_dialog});
            return;
        }
        if (!program.get_subcommands().empty()) return;
        if (tile_of_window->count() > 0) viewer.tile = window_tile;
        status = dapple::run_viewer(viewer);
    });
    return written(run(program, argc, argv, status, parsed));
}
