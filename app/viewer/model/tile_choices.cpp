#include "app/viewer/model/tile_choices.h"

#include <algorithm>
#include <system_error>

#include "core/settings/fields.h"
#include "io/files/tile_library.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

namespace fs = std::filesystem;

TileChoices::TileChoices(const std::string& first) {
    for (const char* name : built_in_tile_names()) names_.emplace_back(name);
    add(first);
}

std::string TileChoices::open(const fs::path& file) {
    // The whole path, so that the same file has the same name however it was found.
    const std::string name = whole_path(file).string();
    load_tile(name);
    add(name);
    return name;
}

void TileChoices::add(const std::string& name) {
    if (std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
}

fs::path folder_of_tiles(const std::string& tile_in_use) {
    std::error_code ignored;
    return fs::is_regular_file(tile_in_use, ignored) ? fs::path(tile_in_use) : working_folder();
}

}  // namespace dapple
