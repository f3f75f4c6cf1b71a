#pragma once
// The window: a picture in, live stippling on screen.

#include <filesystem>
#include <optional>

#include "app/drawing_settings.h"

namespace dapple {

struct ViewerOptions {
    std::optional<std::filesystem::path> image;  // none: the built-in sample picture
    DrawingSettings settings;
    /// Print a line of JSON on standard output whenever what the status line says or where the widgets are
    /// changes. For tests and scripts that drive the window from outside.
    bool log_status = false;
};

/// Opens the window and returns the exit status once it is closed. Prints "ready" on standard output when the
/// first dots are on screen. Throws std::runtime_error if there is no display, or no such tile or picture.
int run_viewer(const ViewerOptions& options);

}  // namespace dapple
