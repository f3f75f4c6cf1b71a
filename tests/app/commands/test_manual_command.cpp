#include <doctest/doctest.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/run_in_shell.h"

using namespace dapple;

TEST_CASE("the manual page names every command and option that help does") {
    const std::string page = std::regex_replace(run_dapple("manual").out, std::regex("\\\\-"), "-");
    std::size_t options = 0;
    std::vector<std::string> commands{""};
    for (std::size_t i = 0; i < commands.size(); ++i)
        for (const std::string& below : commands_in_help(commands[i]))
            commands.push_back(commands[i].empty() ? below : commands[i] + ' ' + below);
    REQUIRE(commands.size() >= 10);
    for (const std::string& command : commands) {
        CAPTURE(command);
        // From the title of its part to the next.
        const std::size_t begin = page.find(".SS dapple" + (command.empty() ? "" : ' ' + command) + "\n");
        REQUIRE(begin != page.npos);
        const std::string part = page.substr(begin, page.find("\n.S", begin + 1) - begin);
        const std::string help = run_dapple(command + " --help").out;
        // CLI11 from 2.5 on has the long names in a column of their own.
        const std::regex line_of_option("\n {2}( {8})?(-[a-z], *)?(--[a-z-]+)");
        for (std::sregex_iterator each(help.begin(), help.end(), line_of_option), end; each != end; ++each) {
            const std::string option = (*each)[3];
            CAPTURE(option);
            CHECK(part.find(option) != part.npos);
            ++options;
        }
    }
    CHECK(options > 80);
    CHECK(page.find("--log-status") == page.npos);  // help does not show it
}

TEST_CASE("nothing in the manual page is taken for a request of roff by mistake") {
    const Outcome manual = run_dapple("manual");
    CHECK(manual.status == 0);
    const std::regex request("\n[.'](?!(TH|SH|SS|TP|PP|br|nf|fi)\\b)");
    CHECK_FALSE(std::regex_search(manual.out, request));
}
