#include "io/command_line/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "io/settings/palettes.h"
#include "io/settings/presets.h"
#include "io/settings/xdg_folders.h"

namespace dapple {
namespace {

struct Completion {
    std::string word;
    std::string about;
};

bool is_hidden(const CLI::App& command) {
    return command.get_group().empty();
}

// The values that an option or a positional takes: "NAME" in capitals stands for anything, "auto|true" for
// these two. `begun` is what is there of the value already.
std::vector<Completion> values_of(const CLI::Option& option, const std::string& begun) {
    std::vector<Completion> values;
    const std::string type = option.get_type_name();
    if (type == "TILE") {
        for (const BuiltInTile& tile : built_in_tiles()) values.push_back({tile.name, tile.about});
        return values;
    }
    if (type == "PRESET") {
        for (const Preset& preset : built_in_presets()) values.push_back({preset.name, preset.about});
        for (const std::string& name : own_presets(within_folder(config_folder(), "presets")))
            values.push_back({name, ""});
        return values;
    }
    if (type == "PENS") {
        // Behind "auto:4:" there may be a palette too.
        const std::size_t second = begun.starts_with("auto:") ? begun.find(':', 5) : begun.npos;
        const std::string before = second == begun.npos ? "" : begun.substr(0, second + 1);
        if (before.empty())
            for (const char* const set : {"greys", "cmyk", "auto:4"}) values.push_back({set, ""});
        for (const NamedPalette& palette : built_in_palettes())
            values.push_back({before + palette.name, palette.about});
        for (const std::string& name : own_palettes(within_folder(config_folder(), "palettes")))
            values.push_back({before + name, ""});
        return values;
    }
    std::istringstream parts(type);
    for (std::string part; std::getline(parts, part, '|');)
        if (part.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789") == part.npos)
            values.push_back({part, ""});
    return values;
}

std::vector<Completion> options_of(const CLI::App& command) {
    std::vector<Completion> options;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) continue;
        for (const std::string& name : option->get_lnames())
            options.push_back({"--" + name, option->get_description()});
    }
    return options;
}

std::vector<Completion> commands_and_positionals_of(const CLI::App& app, const std::string& begun) {
    std::vector<Completion> words;
    for (const CLI::App* command : app.get_subcommands({}))
        if (!is_hidden(*command)) words.push_back({command->get_name(), command->get_description()});
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_positional()) continue;
        for (Completion& value : values_of(*option, begun)) words.push_back(std::move(value));
    }
    return words;
}

// Words that the last of `words` may become: commands, options, and values that have names. `words` are
// those behind "dapple", the last one perhaps empty. Nothing where anything may stand, such as a file's name.
std::vector<Completion> completions(const CLI::App& program, const std::vector<std::string>& words) {
    if (words.empty()) return {};
    const CLI::App* command = &program;
    const CLI::Option* waiting = nullptr;  // for its value
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (waiting) {
            waiting = nullptr;
        } else if (words[i].starts_with('-')) {
            waiting = command->get_option_no_throw(words[i]);
            if (waiting && waiting->get_items_expected_max() == 0) waiting = nullptr;
        } else {
            for (const CLI::App* next : command->get_subcommands({}))
                if (next->check_name(words[i])) command = next;
        }
    }
    std::vector<Completion> found = waiting ? values_of(*waiting, words.back())
                                    : words.back().starts_with('-')
                                        ? options_of(*command)
                                        : commands_and_positionals_of(*command, words.back());
    std::erase_if(found, [&](const Completion& each) { return !each.word.starts_with(words.back()); });
    return found;
}

}  // namespace

Command add_complete_command(CLI::App& program) {
    const auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* const command =
        program.add_subcommand("complete", "Lists what may come next on the command line");
    command->group("");
    command->add_option("words", *words, "After --, the words so far")->type_name("WORDS");
    command->callback([&words = *words, &program] {
        for (const Completion& each : completions(program, words))
            fmt::print("{}\t{}\n", each.word, each.about);
    });
    return words;
}

}  // namespace dapple
