#include "tests/run_in_shell.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/temporary_folder.h"

namespace dapple {

int Outcome::sentences() const {
    return static_cast<int>(std::ranges::count(err, '\n'));
}

Outcome run_in_shell(const std::string& command) {
    setenv("DAPPLE", dapple_program().c_str(), 1);
    setenv("DAPPLE_LAB", lab_program().c_str(), 1);
    const TemporaryFolder folder;
    put_text(folder / "command", command);
    const std::string at = folder.path().string();
    const int status =
        std::system(("/bin/sh " + at + "/command >" + at + "/out 2>" + at + "/err </dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(folder / "out"),
            text_of(folder / "err")};
}

Outcome run_dapple(const std::string& arguments) {
    // Leaks of other libraries are reported where their callers can be told: in the tests of the parts.
    return run_in_shell("export ASAN_OPTIONS=detect_leaks=0; exec \"$DAPPLE\" " + arguments);
}

Outcome run_lab(const std::string& arguments) {
    return run_in_shell("export ASAN_OPTIONS=detect_leaks=0; exec \"$DAPPLE_LAB\" " + arguments);
}

Outcome run_either(const std::string& arguments) {
    static const std::regex of_lab("(analyse|compare|reproduce|volume|tile (rules|search|rank|check))\\b.*");
    return std::regex_match(arguments, of_lab) ? run_lab(arguments) : run_dapple(arguments);
}

std::set<std::string> commands_in_help(const std::string& command) {
    std::istringstream help(run_dapple(command + " --help").out);
    std::set<std::string> found;
    bool among_them = false;
    for (std::string line; std::getline(help, line);) {
        if (line == "Subcommands:" || line == "SUBCOMMANDS:")  // CLI11 from 2.5 on
            among_them = true;
        else if (!line.starts_with("  "))
            among_them = false;
        else if (among_them && line[2] != ' ')
            found.insert(line.substr(2, line.find(' ', 2) - 2));
    }
    return found;
}

}  // namespace dapple
