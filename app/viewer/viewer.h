#pragma once
// The window: a photograph stippled while sliders move, or an environment map with its samples.

#include <filesystem>
#include <optional>
#include <string>

#include "app/viewer/model/lit_map.h"

namespace dapple {

struct ViewerOptions {
    std::optional<std::filesystem::path> image;  // or a project; none: the built-in sample picture
    std::optional<std::string> tile;             // none: the project's, or the usual one
    /// Print a line of JSON on standard output whenever what is shown or where the widgets are changes: see
    /// status_log.h. For tests and scripts that drive the window from outside.
    bool log_status = false;
    /// Neither reads nor writes what is remembered between runs (see memory.h) or kept of pictures.
    bool fresh = false;
    /// Asks for files by our own dialog, whatever was chosen: one that such scripts can use.
    bool own_dialog = false;
};

struct LightViewerOptions {
    std::optional<std::filesystem::path> map;  // none: a sky of our own
    LightsSettings settings;
    bool log_status = false;
    bool fresh = false;
    bool own_dialog = false;
};

/// Opens the window and returns the exit status once it is closed. Prints "ready" on standard output when the
/// first dots or samples are on screen. A picture or map dropped on the window takes the place of the one
/// shown, a tile file that of the tile; a project brings its settings too. A picture or project that cannot
/// be read is told of above the sample. Throws std::runtime_error if there is no display, no such tile or
/// map.
int run_viewer(const ViewerOptions& options);
int run_viewer(const LightViewerOptions& options);

}  // namespace dapple
