#pragma once
// The desktop's own dialog for a file to open, shown by zenity (GNOME and others) or kdialog (KDE).

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace dapple {

/// Whether one of those programs is there.
bool has_desktop_dialog();

/// What is to be opened.
struct OpenQuestion {
    std::string title;
    std::vector<std::string> endings;  // ".png"; none: all files
    std::filesystem::path start;       // its folder is opened
};

/// Waits until the person has chosen. Nothing: no file, or it was stopped. Throws std::runtime_error with one
/// sentence if the dialog cannot be shown.
std::optional<std::filesystem::path> ask_desktop(const OpenQuestion& question, const std::stop_token& stop);

/// Has the desktop show the folder that a file is in, by xdg-open, and does not wait for it.
void show_in_folder(const std::filesystem::path& file);

}  // namespace dapple
