#pragma once
// dapple manual: the manual page, from what --help is made of.

#include <ostream>

namespace CLI {
class App;
}

namespace dapple {

/// Writes the page for man(1): every command with every option, but for those that help does not show.
void write_manual(std::ostream& out, const CLI::App& program);

/// Adds the command, which prints it. Help does not show it: it is for those who install the program.
void add_manual_command(CLI::App& program);

}  // namespace dapple
