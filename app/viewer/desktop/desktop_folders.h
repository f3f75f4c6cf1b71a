#pragma once
// Folders that a person goes to again and again, as the desktop knows them.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace dapple {

// How many dots the window takes on: as many as fit into the computer's memory.

/// As many dots as half of so many bytes of memory hold, both sides of a split view and saving included; at
/// least a million, at most kMostDots.
std::uint64_t most_dots_in(std::uint64_t bytes);

/// Home, the pictures, documents, downloads and desktop of xdg-user-dirs (user-dirs.dirs), and the bookmarks
/// of GTK's dialogs and Nautilus (gtk-3.0/bookmarks), each once, if they are there. `config` is
/// shared_config_folder().
std::vector<std::filesystem::path> desktop_folders(const std::filesystem::path& home,
                                                   const std::filesystem::path& config);

}  // namespace dapple
