#pragma once
// The commands of `dapple-lab`, each in a file of its own.

#include <filesystem>
#include <span>

#include "io/command_line/program.h"
#include "lab/reproduce/printed_numbers.h"

namespace CLI {
class App;
}

namespace dapple {

/// Each adds a command to the program. Commands throw std::runtime_error with one sentence naming the file
/// that is wrong; what was at the output's place stays then.
[[nodiscard]] Command add_analyse_command(CLI::App& program);
[[nodiscard]] Command add_compare_command(CLI::App& program);
[[nodiscard]] Command add_reproduce_command(CLI::App& program);
[[nodiscard]] Command add_lab_tile_command(CLI::App& program);
[[nodiscard]] Command add_volume_command(CLI::App& program);

/// Throws std::runtime_error saying how many numbers differ, and naming `page`, unless none does.
void check_equal(std::span<const ComparedNumber> rows, const std::filesystem::path& page);

}  // namespace dapple
