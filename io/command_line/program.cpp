#include "io/command_line/program.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "core/text/shown_text.h"
#include "io/command_line/wrapped_help.h"
#include "io/command_line/wrong_command.h"
#include "io/signals.h"

namespace dapple {
namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

// Sentences name files, whose names may be anything.
int report(const CLI::App& program, std::string_view sentence, int code) {
    std::fprintf(stderr, "%s: %s\n", program.get_name().c_str(), shortened(printable(sentence)).c_str());
    return code;
}

int run(CLI::App& program, int argc, char** argv, const int& status, const bool& parsed) {
    const std::span words = std::span(argv, argc).subspan(argc > 0 ? 1 : 0);
    if (const auto sentence = wrong_command(program, words)) return report(program, *sentence, kUsage);
    if (const auto sentence = wrong_option(program, words)) return report(program, *sentence, kUsage);
    try {
        program.parse(argc, argv);
        return status;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        return report(program, error.what(), kUsage);
    } catch (const std::bad_alloc&) {
        return report(program, "there is not enough memory for this; try fewer dots or a smaller picture",
                      kFailed);
    } catch (const std::exception& error) {
        // TBB's words, and those of the standard library.
        const std::string_view what = error.what();
        const auto* const system = dynamic_cast<const std::system_error*>(&error);
        if (what.starts_with("pthread_create") ||
            (system && system->code() == std::errc::resource_unavailable_try_again))
            return report(program,
                          "the system starts no more threads for this; allow it more memory or threads "
                          "(ulimit -v, ulimit -u)",
                          kFailed);
        return report(program, what, parsed ? kFailed : kUsage);
    }
}

}  // namespace

int run_program(CLI::App& program, int argc, char** argv, const int& status,
                const std::function<void()>& before) {
    program.formatter(std::make_shared<WrappedHelp>());
    std::optional<ToldWhenStopped> told;
    bool parsed = false;  // all that is wrong before is the command line
    program.parse_complete_callback([&] {
        before();
        parsed = true;
        if (!program.get_subcommands().empty()) told.emplace();
    });
    const int ended = run(program, argc, argv, status, parsed);
    // What was printed may still be on its way, to a disk that is full.
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::cout) return ended;
    return report(program, "the standard output cannot be written: " + std::generic_category().message(errno),
                  kFailed);
}

}  // namespace dapple
