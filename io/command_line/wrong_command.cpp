#include "io/command_line/wrong_command.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

namespace dapple {

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

}  // namespace

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

}  // namespace dapple
