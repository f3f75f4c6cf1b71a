#include "app/commands/files_in_use.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/commands/batch.h"
#include "app/files/save_drawing.h"
#include "app/files/separations.h"
#include "app/files/sheet_files.h"

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

// What a command line names: each word of it that is a file's name, and what stands behind a ':' in one.
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

void add_drawing(const RenderOptions& options, const fs::path& output, std::vector<FileInUse>& written) {
    const PenChoice& choice = options.drawing.pens;
    Palette pens;
    if (choice.set != PenSet::automatic) pens = palette_of(choice);
    sort_pens(pens, choice.order);
    std::vector<fs::path> files = is_several(options.drawing.sheets)
                                      ? files_of(output, options.drawing.sheets, options.saving, pens)
                                      : files_of(output, format_of(options), options.saving, pens);
    for (fs::path& file : files)
        written.push_back({std::move(file), files.size() > 1 ? "a part of the drawing" : "the drawing"});
}

}  // namespace

void check_apart(const CLI::App& command, std::initializer_list<std::string_view> written_by,
                 const std::vector<FileInUse>& written, const std::vector<FileInUse>& more_read) {
    std::vector<FileInUse> read = more_read;
    std::ranges::move(files_read(command, written_by), std::back_inserter(read));
    check_apart(written, read);
}

void check_apart(const CLI::App& command, RenderOptions& options, std::span<const fs::path> pictures) {
    // A drawing may take the place of the one that its settings are from, but the figures may not.
    options.read = files_read(command, {"--output", "--stats", "--settings-from"});
    if (options.image) options.read.push_back({*options.image, "the picture"});
    options.read.push_back({options.drawing.tile, "the tile"});
    std::vector<FileInUse> written;
    for (const fs::path& picture : pictures)
        add_drawing(options, output_in(options.output, picture, format_of(options)), written);
    if (pictures.empty() && !is_standard_stream(options.output))
        add_drawing(options, options.output, written);
    const bool figures = options.stats && !is_standard_stream(*options.stats);
    if (figures) written.push_back({*options.stats, "the figures"});
    check_apart(written, options.read);
    if (figures && command.count("--settings-from") > 0)
        check_apart({written.back()}, {{command["--settings-from"]->as<std::string>(), "the settings"}});
}

}  // namespace dapple
