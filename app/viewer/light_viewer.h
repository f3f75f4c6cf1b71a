#pragma once
// The window of an environment map: its samples over it, and how well they light a sphere.

#include <filesystem>
#include <optional>

#include "app/viewer/panels/lights_panel.h"

namespace dapple {

struct LightViewerOptions {
    std::optional<std::filesystem::path> map;  // none: a sky of our own
    LightsSettings settings;
    /// Print a line of JSON on standard output whenever what is shown or where the widgets are changes:
    /// see light_status_json().
    bool log_status = false;
};

/// Opens the window and returns the exit status once it is closed. Prints "ready" on standard output when the
/// map's first samples are on screen. A map dropped on the window takes the place of the one shown, a tile
/// file that of the tile. Throws std::runtime_error if there is no display, no such tile, or if the first map
/// cannot be read.
int run_light_viewer(const LightViewerOptions& options);

}  // namespace dapple
