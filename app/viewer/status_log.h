#pragma once
// What the window tells programs that drive it.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>

#include "app/viewer/panels/status_line.h"
#include "app/viewer/widgets.h"

namespace dapple {

/// Where the mouse was in a frame, in window coordinates, and its left button.
/// How the program itself is.
struct HealthFacts {
    double longest_frame_ms = 0;  // that the window took for one, from the events it knew to showing it
    int gl_errors = 0;
};

struct MouseFacts {
    glm::vec2 position{0};
    bool down = false;
};

/// One line of JSON: {"dots": .., "duplicates": .., "scale": .., "zoom": .., "placings": .., "place_ms": ..,
/// "draw_ms": .., "mouse": [x, y], "mouse_down": .., "right": {"dots": .., "duplicates": .., "scale": ..,
/// "divider": .., "repetition": .., "left_repetition": ..}, "loupe": {"repetition": .., "layers": ..,
/// "level": ..}, "widgets": {"Scale": [x0, y0, x1, y1], ..}}. placings counts since the start, widgets are in
/// window coordinates. "right" is there while the split view shows dots (an unknown repetition is null),
/// "loupe" while the lens shows something.
std::string status_json(const StatusFacts& facts, std::uint64_t placings, const MouseFacts& mouse,
                        const HealthFacts& health, const WidgetPlaces& widgets);

struct LightStatus {
    std::size_t samples = 0;
    std::uint64_t samplings = 0;  // since the map was opened
    bool sampling = false;        // another is under way
    double stops = 0;             // LightsSettings::stops
    double difference = 0;        // LightsFacts::difference
    double zoom = 1;              // how many times larger than fitted the map is
    bool saving = false;          // a file is being written
};

/// The same of the window of an environment map: {"samples": .., "samplings": .., "sampling": ..,
/// "stops": .., "difference": .., "zoom": .., "saving": .., "mouse": [x, y], "mouse_down": .., "widgets":
/// {..}}.
std::string light_status_json(const LightStatus& status, const MouseFacts& mouse, const HealthFacts& health,
                              const WidgetPlaces& widgets);

}  // namespace dapple
