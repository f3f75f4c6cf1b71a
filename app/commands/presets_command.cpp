#include "app/commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "io/settings/presets.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

// Prints a line each: the name, a tab, what it is about.
void add_presets_command(CLI::App& program) {
    program
        .add_subcommand("presets",
                        "List the presets for render --preset: built-in ones and those that the window saved")
        ->callback([] {
            for (const Preset& preset : built_in_presets()) fmt::print("{}\t{}\n", preset.name, preset.about);
            for (const std::string& name : own_presets(within_folder(config_folder(), "presets")))
                fmt::print("{}\tyour preset\n", name);
        });
}

}  // namespace dapple
