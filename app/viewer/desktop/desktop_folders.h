#pragma once
// Folders that a person goes to again and again, as the desktop knows them.

#include <filesystem>
#include <vector>

namespace dapple {

/// Home, the pictures, documents, downloads and desktop of xdg-user-dirs (user-dirs.dirs), and the bookmarks
/// of GTK's dialogs and Nautilus (gtk-3.0/bookmarks), each once, if they are there. `config` is
/// shared_config_folder().
std::vector<std::filesystem::path> desktop_folders(const std::filesystem::path& home,
                                                   const std::filesystem::path& config);

}  // namespace dapple
