#pragma once
// A program with commands, from its first word to its exit status.

#include <functional>

namespace CLI {
class App;
}

namespace dapple {

/// Parses the command line and runs its command, or the program's own callback without one. What is wrong is
/// one sentence on the standard error, behind the program's name. Returns 0 if all was done (`status`, which
/// the callbacks may set), 1 if something could not be, 2 if the command line is wrong. `before` is called
/// once all is read, before anything is done; what it throws is a wrong command line.
int run_program(
    CLI::App& program, int argc, char** argv, const int& status, const std::function<void()>& before = [] {});

}  // namespace dapple
