// dapple: stipples pictures, in a window and on the command line.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/analyse.h"
#include "app/commands/lights.h"
#include "app/commands/render.h"
#include "app/commands/reproduce.h"
#include "app/commands/tile.h"
#include "app/viewer/light_viewer.h"
#include "app/viewer/viewer.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

int report(const char* sentence, int code) {
    std::fprintf(stderr, "dapple: %s\n", sentence);
    return code;
}

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

// What is wrong with a first word that was meant as a command: "rendr" for "render". Nothing if it is one, or
// may be a picture.
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
        sentence += "; --help shows those there are";
    return sentence;
}

int run(CLI::App& program, int argc, char** argv, const int& status) {
    if (const auto sentence = wrong_command(program, std::span(argv, argc).subspan(argc > 0 ? 1 : 0)))
        return report(sentence->c_str(), kUsage);
    try {
        program.parse(argc, argv);
        return status;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        return report(error.what(), kUsage);
    } catch (const std::bad_alloc&) {
        return report("there is not enough memory for this; try fewer dots or a smaller picture", kFailed);
    } catch (const std::exception& error) {
        return report(error.what(), kFailed);
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program{"Stippling: pictures drawn with dots, live in a window or into files.", "dapple"};
    program.set_version_flag("--version", "dapple " DAPPLE_VERSION, "Show the version");
    program.footer(
        "Without a command, a window opens with the picture (the built-in sample without one).\n"
        "dapple COMMAND --help says more.\n\n"
        "Examples:\n"
        "  dapple cat.jpg                               look at it, move the sliders\n"
        "  dapple render cat.jpg -o cat.svg             the same as a file\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000");
    program.require_subcommand(0, 1);

    int status = 0;
    dapple::ViewerOptions viewer;
    program.add_option("image", viewer.image, "The picture to look at")->type_name("IMAGE");
    // For scripts that drive the window: nothing that help need tell.
    program.add_flag("--log-status", viewer.log_status)->group("");
    const dapple::RenderCommand render(program);
    const dapple::ReproduceCommand reproduce(program);
    const dapple::AnalyseCommand analyse(program);
    const dapple::LightsCommand lights(program);
    const dapple::TileCommand tile(program);

    program.callback([&] {
        if (const dapple::LightsOptions* map = lights.window()) {
            dapple::LightsSettings settings;
            settings.request = map->request;
            settings.tile = map->tile;
            settings.stops = map->exposure.value_or(0);
            settings.turn_degrees = map->rotation_degrees;
            status = dapple::run_light_viewer({map->map, settings, viewer.log_status});
            return;
        }
        if (!program.get_subcommands().empty()) return;
        status = dapple::run_viewer(viewer);
    });
    return run(program, argc, argv, status);
}
