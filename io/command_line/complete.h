#pragma once
// dapple complete: what may stand next on the command line. The shells' scripts in packaging/ ask it at each
// Tab, so that they know no option themselves.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dapple {

struct Completion {
    std::string word;
    std::string about;
};

/// Words that the last of `words` may become: commands, options, and values that have names. `words` are
/// those behind "dapple", the last one perhaps empty. Nothing where anything may stand, such as a file's
/// name.
std::vector<Completion> completions(const CLI::App& program, const std::vector<std::string>& words);

/// Adds the command, which prints them a line each, about what after a tab. Help does not show it. It holds
/// what it is given, so it has to live until all is parsed and done.
class CompleteCommand {
 public:
    explicit CompleteCommand(CLI::App& program);
    CompleteCommand(const CompleteCommand&) = delete;
    CompleteCommand& operator=(const CompleteCommand&) = delete;

 private:
    std::vector<std::string> words_;
};

}  // namespace dapple
