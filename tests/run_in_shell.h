#pragma once
// Commands run as a person runs them, in a shell.

#include <set>
#include <string>

namespace dapple {

struct Outcome {
    int status = -1;  // of the shell: 128 + n if signal n ended it
    std::string out, err;

    /// Lines on standard error.
    int sentences() const;
};

/// Runs `command` with /bin/sh, where "$DAPPLE" and "$DAPPLE_LAB" are the programs that were built beside the
/// tests, wherever that is.
Outcome run_in_shell(const std::string& command);

/// Runs it: `dapple ` + arguments.
Outcome run_dapple(const std::string& arguments);
/// The same with `dapple-lab `.
Outcome run_lab(const std::string& arguments);
/// The same with the program that has the command.
Outcome run_either(const std::string& arguments);

/// What a command's help lists under "Subcommands:"; of the program itself with "".
std::set<std::string> commands_in_help(const std::string& command);

}  // namespace dapple
