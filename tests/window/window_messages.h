#pragma once
// What a window is told by others than mouse and keyboard: its manager, and windows that things are dragged
// from.

#include <filesystem>
#include <string>

namespace dapple {

/// As its manager does when somebody clicks its cross. Nothing if there is no window whose title ends so.
void ask_to_close(const std::string& end_of_title);

/// As a file manager does when a file is let go over a place of the screen, pixels (XDND, version 5). Waits
/// at most some seconds for the window to take it.
void drop_file(const std::string& end_of_title, const std::filesystem::path& file, int x, int y);

}  // namespace dapple
