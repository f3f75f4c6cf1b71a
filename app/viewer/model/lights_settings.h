#pragma once
// All that the window of an environment map edits, as one value.

#include <optional>
#include <string>

#include "core/lights/direction.h"
#include "core/lights/light_samples.h"

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

}  // namespace dapple
