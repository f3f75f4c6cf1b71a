#pragma once
// The desktop's own programs, and its dialog for a file to open: zenity (GNOME and others) or kdialog (KDE).

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace dapple {

// The output of a program, which is run, waited for, and ended if need be.

/// Whether a program of that name is in one of PATH's folders.
bool is_in_path(const std::string& program);

struct ChildLimits {
    std::size_t most_bytes = 1 << 20;
    std::optional<std::chrono::seconds> longest = {};  // none: as long as a person takes
};

struct ChildOutput {
    int status = 0;  // its exit status; -1: it was ended by a signal
    std::string bytes;
};

/// Runs a program found in PATH, without input, and gives back what it wrote into its standard output.
/// Nothing if it was stopped, which ends it. Throws std::runtime_error with one sentence if it cannot be
/// started, says more or takes longer than it may.
std::optional<ChildOutput> output_of(const std::vector<std::string>& words, const ChildLimits& limits,
                                     const std::stop_token& stop = {});

/// Whether a program with such a dialog is there.
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
