#pragma once

#include <optional>
#include <string>

#include "app/files/save_lights.h"
#include "app/viewer/panels/tile_row.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"

namespace dapple {

/// All that the window of an environment map edits.
struct LightsSettings {
    LightRequest request{};
    std::string tile = "paper16";
    double stops = 0;         // exposure over the natural one
    double turn_degrees = 0;  // of the map about the up axis, -180..180
    bool samples_shown = true;
    std::optional<SphereConvention> convention{};  // of a file; none: the one usual for its kind

    bool operator==(const LightsSettings&) const = default;
};

/// What the panel tells.
struct LightsFacts {
    double place_ms = 0, share_ms = 0;
    double difference = 0;  // of irradiance from the full map's, mean over normals, relative
    double flux_error = 0;  // of the weights' sum, relative
};

/// Sections "Samples" and "View", and the figures. True while something changes. `tiles` can be chosen from.
/// Without facts the samples are still being taken, and it says so in their place.
bool draw_lights_panel(LightsSettings& settings, const std::optional<LightsFacts>& facts,
                       const TileList& tiles);

/// The room that the options need in the file dialog.
inline constexpr int kLightExportRows = 2;

/// What goes with a kind of file: the axes of its directions. True when another is chosen.
bool draw_light_export_panel(LightsSettings& settings, LightFile format);

}  // namespace dapple
