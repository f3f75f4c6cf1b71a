#pragma once
// What the window tells programs that drive it.

#include <string>

#include "app/viewer/panels/status_line.h"
#include "app/viewer/widgets.h"

namespace dapple {

/// Where the mouse was in a frame, in window coordinates, and its left button.
struct MouseFacts {
    glm::vec2 position{0};
    bool down = false;
};

/// One line of JSON: {"dots": .., "duplicates": .., "scale": .., "zoom": .., "placings": .., "place_ms": ..,
/// "draw_ms": .., "mouse": [x, y], "mouse_down": .., "widgets": {"Scale": [x0, y0, x1, y1], ..}}; placings
/// counts since the start, widgets are in window coordinates.
std::string status_json(const StatusFacts& facts, std::uint64_t placings, const MouseFacts& mouse,
                        const WidgetPlaces& widgets);

}  // namespace dapple
