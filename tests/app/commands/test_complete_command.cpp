// What the shells offer at Tab, by the scripts that are installed.

#include <doctest/doctest.h>

#include <set>
#include <sstream>
#include <string>

#include "tests/places.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

// The words that may stand next, without what they are about.
std::set<std::string> offered(const std::string& words) {
    const Outcome outcome = run_dapple("complete -- " + words);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    std::set<std::string> found;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) found.insert(line.substr(0, line.find('\t')));
    return found;
}

}  // namespace

TEST_CASE("every command that help shows is offered, and no other") {
    const std::set<std::string> commands = commands_in_help("");
    CHECK(commands.contains("render"));
    CHECK(offered("''") == commands);
    CHECK(offered("tile ''") == commands_in_help("tile"));
}

TEST_CASE("options are offered where they belong, and values where they have names") {
    CHECK(offered("render cat.jpg --re") == std::set<std::string>{"--region", "--registration", "--relax"});
    CHECK(offered("--re").empty());
    CHECK(offered("--log").empty());  // not in the help
    CHECK(offered("render --placer ''") == std::set<std::string>{"exact", "figure8"});
    CHECK(offered("render --invert --tile paper") == std::set<std::string>{"paper16", "paper20"});
    CHECK(offered("tile show latt") == std::set<std::string>{"lattice24", "lattice28", "lattice36"});
    CHECK(offered("render --pens fi") == std::set<std::string>{"fineliners"});
    CHECK(offered("render --pens auto:3:fi") == std::set<std::string>{"auto:3:fineliners"});
    CHECK(offered("render --pens auto:3:au").empty());
    CHECK(offered("render --width ''").empty());
    CHECK(offered("render -o ''").empty());
}

TEST_CASE("bash completes with the script that is installed") {
    const auto completed = [](const std::string& words, int last) {
        return run_in_shell("export ASAN_OPTIONS=detect_leaks=0; exec bash -c '. " +
                            source_folder().string() + "/packaging/dapple.bash; COMP_WORDS=(\"$DAPPLE\" " +
                            words + "); COMP_CWORD=" + std::to_string(last) +
                            "; _dapple \"$DAPPLE\"; echo \"${COMPREPLY[@]}\"'")
            .out;
    };
    CHECK(completed("ren", 1) == "render\n");
    CHECK(completed("render --order s x", 3) == "shortest space\n");
    CHECK(completed("render cat", 2) == "\n");
    // Bash has colons as words of their own, and wants what follows the last one.
    CHECK(completed("render --pens auto : 3 : fi", 7) == "fineliners\n");
}
