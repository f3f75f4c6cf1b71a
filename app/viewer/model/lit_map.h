#pragma once
// An environment map and the samples taken of it.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/image/environment.h"
#include "core/image/grid.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/lights/lit_objects.h"
#include "core/watch.h"

namespace dapple {

/// How samples are shown on the map.
enum class SampleMarks {
    points,
    areas,  // outlines of what is nearer to each than to any other
    none,
};

/// All that the window of an environment map edits.
struct LightsSettings {
    LightRequest request{};
    std::string tile = "paper16";
    double stops = 0;         // exposure over the natural one
    double turn_degrees = 0;  // of the map about the up axis, -180..180
    SampleMarks marks = SampleMarks::points;
    std::optional<SphereConvention> convention{};  // of a file; none: the one usual for its kind

    bool operator==(const LightsSettings&) const = default;
};

/// How well the samples stand for the map.
struct LightsInfo {
    double place_ms = 0, share_ms = 0;
    RelativeError irradiance{}, glossy{};  // beside the full map's, over all normals
    double flux_error = 0;                 // of the weights' sum, relative
};

/// A map and what showing it needs, made once: its light takes a second.
struct LitMap {
    explicit LitMap(EnvironmentMap environment);

    EnvironmentMap map;
    LitObjects exact;
    double natural_exposure;
    Grid<glm::vec3> preview;  // at most 2,048 wide
};

/// A map's samples and what they light.
struct SampledMap {
    std::vector<glm::dvec2> places;   // on the map, 0..1
    std::optional<LitObjects> found;  // none: there are no samples yet
    LightsInfo info;
    /// Which sample is the nearest to each pixel of the preview, which is cut to be twice as wide as high.
    Grid<std::uint32_t> nearest;
};
/// Nothing if stopped. Throws std::runtime_error if the tile or its samples cannot be had.
std::optional<SampledMap> sampled(const LitMap& lit, const LightsSettings& settings, const Watch& watch = {});

}  // namespace dapple
