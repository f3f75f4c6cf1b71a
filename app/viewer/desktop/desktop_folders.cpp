#include "app/viewer/desktop/desktop_folders.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

#include "app/viewer/desktop/pasted_picture.h"
#include "core/drawing/settings.h"

namespace dapple {

namespace {

// A dot is five floats and four bytes of colour in the drawing shown, in the one being placed and in one kept
// for its memory; all that twice in a split view, and once more while it is saved. Relaxing one needs 44
// bytes a dot for the while. The drawing as it was has some of the other half. The graphics driver gets them
// by and by.
constexpr std::uint64_t kBytesPerDot = 250;
constexpr std::uint64_t kShare = 2;  // one part in so many is for dots
constexpr std::uint64_t kFewest = 1'000'000;

}  // namespace

std::uint64_t most_dots_in(std::uint64_t bytes) {
    return std::clamp(bytes / kShare / kBytesPerDot, kFewest, kMostDots);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFolders = 12;

void add_folder(std::vector<fs::path>& folders, const fs::path& folder) {
    std::error_code ignored;
    fs::path plain = folder.lexically_normal();
    if (!plain.has_filename()) plain = plain.parent_path();
    const bool known = std::ranges::find(folders, plain) != folders.end();
    if (!known && folders.size() < kMostFolders && plain.is_absolute() && fs::is_directory(plain, ignored))
        folders.push_back(plain);
}

// XDG_PICTURES_DIR="$HOME/Pictures"
fs::path user_folder(const std::string& line, const fs::path& home) {
    constexpr std::string_view kHome = "$HOME/";
    const std::size_t from = line.find('"'), to = line.rfind('"');
    if (from == line.npos || to <= from) return {};
    const std::string value = line.substr(from + 1, to - from - 1);
    return value.starts_with(kHome) ? home / value.substr(kHome.size()) : fs::path(value);
}

}  // namespace

std::vector<fs::path> desktop_folders(const fs::path& home, const fs::path& config) {
    std::vector<fs::path> folders;
    add_folder(folders, home);
    std::ifstream user_folders(config / "user-dirs.dirs");
    for (std::string line; std::getline(user_folders, line);)
        for (const char* kind : {"PICTURES", "DOCUMENTS", "DOWNLOAD", "DESKTOP"})
            if (line.starts_with(std::string("XDG_") + kind + "_DIR="))
                add_folder(folders, user_folder(line, home));
    // A URI, and perhaps a blank and another name for it.
    std::ifstream bookmarks(config / "gtk-3.0/bookmarks");
    for (std::string line; std::getline(bookmarks, line);)
        if (line.starts_with("file:"))
            add_folder(folders, path_named_by(line.substr(0, line.find(' ')), home));
    return folders;
}

}  // namespace dapple
