#include "io/command_line/program.h"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>
#include <regex>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/text/shown_text.h"
#include "io/files/save_drawing.h"
#include "io/signals.h"

namespace dapple {

namespace {

namespace fs = std::filesystem;

// What sentences call a file that an option names.
std::string called(const CLI::Option& option, const fs::path& file) {
    using Called = std::pair<std::string_view, const char*>;
    constexpr std::array kCalled{Called{"--tile", "the tile"},
                                 Called{"--mask", "the mask"},
                                 Called{"--finer", "the mask"},
                                 Called{"--settings-from", "the settings"},
                                 Called{"map", "the map"},
                                 Called{"tile", "the tile"},
                                 Called{"input", "what is analysed"},
                                 Called{"pictures", "a picture that is compared"}};
    const std::string name = option.get_single_name();
    if (name == "image") return file.extension() == ".dapple" ? "the project" : "the picture";
    for (const auto& [its_name, what] : kCalled)
        if (option.check_name(std::string(its_name))) return what;
    return option.get_positional() ? "a file that is read" : "what --" + name + " reads";
}

bool is_a_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

}  // namespace

std::vector<FileInUse> files_read(const CLI::App& command,
                                  std::initializer_list<std::string_view> written_by) {
    std::vector<FileInUse> files;
    for (const CLI::Option* const option : command.get_options()) {
        const auto is_it = [&](std::string_view name) { return option->check_name(std::string(name)); };
        if (std::ranges::any_of(written_by, is_it)) continue;
        const std::vector<std::string> words = option->results();
        for (std::string_view word : words) {
            while (!is_a_file(word) && word.find(':') != word.npos) word.remove_prefix(word.find(':') + 1);
            if (is_a_file(word) || is_standard_stream(word))
                files.push_back({fs::path(word), called(*option, word)});
        }
    }
    return files;
}

void check_apart(const CLI::App& command, std::initializer_list<std::string_view> written_by,
                 const std::vector<FileInUse>& written, const std::vector<FileInUse>& more_read) {
    std::vector<FileInUse> read = more_read;
    std::ranges::move(files_read(command, written_by), std::back_inserter(read));
    check_apart(written, read);
}

void print_remark(const std::filesystem::path& file, const std::string& remark) {
    if (!remark.empty()) fmt::print(stderr, "dapple: {}: {}\n", printable(file.string()), remark);
}

Picture read_with_remark(const std::filesystem::path& file, PictureLimit limit, PictureColours colours) {
    Picture picture = read_picture(file, limit, colours);
    print_remark(file, picture.remark);
    return picture;
}

namespace {

// How many letters have to be put in, left out, changed or swapped with the next (Damerau 1964).
std::size_t slips_between(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> slips(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t k = 0; k <= b.size(); ++k) {
            if (i == 0 || k == 0) {
                slips[i][k] = i + k;
                continue;
            }
            slips[i][k] = std::min(
                {slips[i - 1][k] + 1, slips[i][k - 1] + 1, slips[i - 1][k - 1] + (a[i - 1] != b[k - 1])});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                slips[i][k] = std::min(slips[i][k], slips[i - 2][k - 2] + 1);
        }
    }
    return slips[a.size()][b.size()];
}

// What is wrong with a first word that was meant as a command: "rendr" for "render". Nothing if it is one,
// or may be a picture.
std::optional<std::string> wrong_command(const CLI::App& app, std::span<char* const> words) {
    if (words.empty()) return std::nullopt;
    const std::string_view word = words.front();
    const auto commands = app.get_subcommands({});
    if (commands.empty() || word.empty() || word.starts_with('-')) return std::nullopt;
    const CLI::App* nearest = commands.front();
    for (const CLI::App* command : commands) {
        const std::string name = command->get_name();
        if (name == word) return wrong_command(*command, words.subspan(1));
        if (slips_between(word, name) < slips_between(word, nearest->get_name())) nearest = command;
    }
    std::error_code error;
    const bool like_a_file = word.find_first_of("./") != word.npos || std::filesystem::exists(word, error);
    if (like_a_file) return std::nullopt;
    const std::string name = nearest->get_name();
    std::string sentence = "there is no command \"" + std::string(word) + "\"";
    if (2 * slips_between(word, name) < name.size())
        sentence += "; did you mean \"" + name + "\"?";
    else
        sentence += "; --help lists them all";
    return sentence;
}

// The same for the first option that does not exist: "--dotz" for "--dots".
std::optional<std::string> wrong_option(const CLI::App& app, std::span<char* const> words) {
    const CLI::App* command = &app;
    std::string usage = app.get_name();
    for (const std::string_view word : words) {
        if (word == "--") break;
        if (!word.starts_with("--")) {
            for (const CLI::App* const below : command->get_subcommands({})) {
                if (below->get_name() != word) continue;
                command = below;
                (usage += ' ') += word;
                break;
            }
            continue;
        }
        const std::string_view name = word.substr(2, word.find('=') - 2);
        std::vector<std::string> names;
        for (const CLI::Option* option : command->get_options())
            names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
        if (std::ranges::find(names, name) != names.end()) continue;
        const std::string nearest = *std::ranges::min_element(
            names, {}, [&](const auto& known) { return slips_between(name, known); });
        const bool near = 3 * slips_between(name, nearest) <= nearest.size();
        return "there is no option --" + std::string(name) +
               (near ? "; did you mean --" + nearest + "?" : "; " + usage + " --help lists them all");
    }
    return std::nullopt;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
    // Of a line of two columns: the first, and the gap. A long name has the second one in the next line.
    static const std::regex first_column(" {10,}| *[^ ]+( [^ ]+)* {2,}(?=[^ ])");
    std::string result;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line); result += line + '\n') {
        std::smatch first;
        const bool columns =
            std::regex_search(line, first, first_column, std::regex_constants::match_continuous);
        if (!columns && line.starts_with(' ')) continue;
        const std::size_t column = columns ? static_cast<std::size_t>(first.length()) : 0;
        const std::string margin(column > width / 2 ? 0 : column, ' ');
        while (line.size() > width) {
            std::size_t end = line.rfind(' ', width);
            if (end == line.npos || end < std::max<std::size_t>(margin.size(), 1))
                end = line.find(' ', width);
            if (end == line.npos) break;
            result += line.substr(0, end) + '\n';
            line = margin + line.substr(std::min(line.find_first_not_of(' ', end), line.size()));
        }
    }
    if (!text.ends_with('\n') && !result.empty()) result.pop_back();
    return result;
}

namespace {

// Of the terminal that the standard output is; 0: it is none.
std::size_t terminal_columns() {
    winsize size{};
    return ::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

// Wrapped on a terminal alone: programs and files get each line whole.
struct WrappedHelp : CLI::Formatter {
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        const std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
        constexpr std::size_t kNarrowest = 60;
        const std::size_t columns = terminal_columns();
        return columns == 0 ? help : wrapped(help, std::max(columns, kNarrowest));
    }
};

// roff takes a backslash, a hyphen, and a point or quote that begins a line for something else.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += "\\&";
        if (c == '\\' || c == '-') result += '\\';
        result += c == '\\' ? 'e' : c;
    }
    return result;
}

// The help of a command and of all below it, line by line.
void write_help(std::ostream& out, const CLI::App& command, const std::string& name) {
    constexpr std::size_t kColumns = 72;  // beside the margin that pages have
    const std::string help = CLI::Formatter().make_help(&command, name, CLI::AppFormatMode::Normal);
    out << ".SS " << roff(name) << "\n.nf\n" << roff(wrapped(help, kColumns)) << ".fi\n";
    for (const CLI::App* below : command.get_subcommands({}))
        if (!below->get_group().empty()) write_help(out, *below, name + ' ' + below->get_name());
}

void write_manual(std::ostream& out, const CLI::App& program) {
    const std::string name = program.get_name();
    out << ".TH " << name << " 1 \"\" \"" << roff(program.version()) << "\" \"User Commands\"\n.SH NAME\n"
        << roff(name) << " \\- " << roff(program.get_description()) << "\n.SH COMMANDS\n";
    write_help(out, program, name);
    out << ".SH EXIT STATUS\n"
           ".TP\n0\nAll was done.\n"
           ".TP\n1\nSomething failed; the standard error has a sentence about it.\n"
           ".TP\n2\nThe command line is wrong; nothing was done.\n";
}

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
        return report(program, "not enough memory for this; try fewer dots or a smaller picture", kFailed);
    } catch (const std::exception& error) {
        // TBB's words, and those of the standard library.
        const std::string_view what = error.what();
        const auto* const system = dynamic_cast<const std::system_error*>(&error);
        if (what.starts_with("pthread_create") ||
            (system && system->code() == std::errc::resource_unavailable_try_again))
            return report(
                program,
                "the system allows no more threads; allow more memory or threads (ulimit -v, ulimit -u)",
                kFailed);
        return report(program, what, parsed ? kFailed : kUsage);
    }
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> wrapped_help() {
    return std::make_shared<WrappedHelp>();
}

int run_program(CLI::App& program, int argc, char** argv, const int& status,
                const std::function<void()>& before) {
    program.formatter(wrapped_help());
    const Command complete = add_complete_command(program);
    program.add_subcommand("manual", "The manual page, for man")->group("")->callback([&program] {
        write_manual(std::cout, program);
    });
    std::optional<ToldWhenStopped> told;
    bool parsed = false;  // all that is wrong before is the command line
    program.parse_complete_callback([&] {
        if (before) before();
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
