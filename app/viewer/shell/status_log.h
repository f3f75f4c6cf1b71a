#pragma once
// What the window tells programs that drive it.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include "app/viewer/panels/status_line.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

/// How the program itself is.
struct HealthInfo {
    double longest_frame_ms = 0;  // that the window took for one, from the events it knew to showing it
    double longest_work_ms = 0;   // of that, its own processor time: the machine does other things too
    int gl_errors = 0;
};

/// Where the mouse was in a frame, in window coordinates, and its left button.
struct MouseInfo {
    glm::vec2 position{0};
    bool down = false;
};

// The window writes a line of JSON whenever something in it changed.

/// What a drawing's window tells: {"dots": .., "duplicates": .., "scale": .., "zoom": .., "placings": ..,
/// "place_ms": .., "draw_ms": .., "steps": .., "all_steps": .., "right": {"dots": .., "duplicates": ..,
/// "scale": .., "divider": .., "repetition": .., "left_repetition": ..}, "loupe": {"repetition": ..,
/// "layers": .., "level": ..}}. placings counts since the start. "right" is there while the split view shows
/// dots (an unknown repetition is null), "loupe" while the lens shows something.
nlohmann::ordered_json status_json(const StatusInfo& info, std::uint64_t placings);

struct LightStatus {
    std::size_t samples = 0;
    std::uint64_t samplings = 0;  // since the start
    bool sampling = false;        // another is under way
    double stops = 0;             // LightsSettings::stops
    double difference = 0;        // LightsInfo::irradiance.mean
    double zoom = 1;              // how many times larger than fitted the map is
    bool saving = false;          // a file is being written
};

/// What an environment map's window tells: {"samples": .., "samplings": .., "sampling": .., "stops": ..,
/// "difference": .., "zoom": .., "saving": ..}.
nlohmann::ordered_json status_json(const LightStatus& status);

/// Adds what both have: {"longest_frame_ms": .., "longest_work_ms": .., "gl_errors": .., "mouse": [x, y],
/// "mouse_down": .., "row_with_keys": .., "widgets": {"Dots in black": [x0, y0, x1, y1], ..}}, places in
/// window coordinates. row_with_keys is a number of its own for each row, 0 for none.
void add_input(nlohmann::ordered_json& line, const MouseInfo& mouse, const HealthInfo& health,
               const WidgetNotes& widgets);

}  // namespace dapple
