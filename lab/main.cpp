// dapple-lab: studies what dapple draws with - tiles, points, methods beside it, and dots in space.

#include <CLI/CLI.hpp>
#include <array>

#include "io/command_line/program.h"
#include "lab/commands/commands.h"

int main(int argc, char** argv) {
    CLI::App program{"The laboratory of dapple: searches, measures and compares.", "dapple-lab"};
    program.set_version_flag("--version", "dapple-lab " DAPPLE_VERSION, "Show the version");
    program.footer(
        "dapple-lab COMMAND --help says more.\n"
        "Exit status: 0 if all was done, 1 if something could not be, 2 if the command line is wrong.\n\n"
        "Examples:\n"
        "  dapple-lab analyse cat.svg -o cat.html            how even its dots are, and whether they repeat\n"
        "  dapple-lab compare cat.jpg --page compare.html    beside the methods that came before\n"
        "  dapple-lab tile search --points 20                the best tiles of 20 points");
    program.require_subcommand(1);
    const std::array commands{dapple::add_analyse_command(program), dapple::add_compare_command(program),
                              dapple::add_reproduce_command(program), dapple::add_lab_tile_command(program),
                              dapple::add_volume_command(program)};
    return dapple::run_program(program, argc, argv, 0);
}
