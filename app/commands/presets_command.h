#pragma once
// dapple presets: the names that render --preset takes.

namespace CLI {
class App;
}

namespace dapple {

/// Adds the command, which prints a line each: the name, a tab, what it is about.
void add_presets_command(CLI::App& program);

}  // namespace dapple
