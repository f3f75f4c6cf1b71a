#pragma once
// The commands of `dapple`, each in a file of its own.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/lights/light_samples.h"
#include "io/command_line/program.h"

namespace dapple {

/// Each adds a command to the program. Commands throw std::runtime_error with one sentence naming the file
/// that is wrong; what was at the output's place stays then.
[[nodiscard]] Command add_render_command(CLI::App& program);
[[nodiscard]] Command add_record_command(CLI::App& program);
[[nodiscard]] Command add_tile_command(CLI::App& program);
[[nodiscard]] Command add_test_sheet_command(CLI::App& program);
[[nodiscard]] Command add_mask_command(CLI::App& program);
void add_presets_command(CLI::App& program);

/// An environment map to look at.
struct ShownMap {
    std::optional<std::filesystem::path> map;  // none: a sky of our own
    LightRequest request;
    std::string tile;
    double stops = 0;  // over the natural exposure
    double turn_degrees = 0;
};

/// `show` opens a window, where the command was given no output.
[[nodiscard]] Command add_lights_command(CLI::App& program, std::function<void(const ShownMap&)> show);

}  // namespace dapple
