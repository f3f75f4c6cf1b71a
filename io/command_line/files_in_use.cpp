#include "io/command_line/files_in_use.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "io/files/save_drawing.h"

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

}  // namespace dapple
