#pragma once
// What the window tells programs that drive it.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

/// What a drawing's window tells: {"dots": .., "duplicates": .., "scale": .., "zoom": .., "placings": ..,
/// "place_ms": .., "draw_ms": .., "steps": .., "all_steps": .., "right": {"dots": .., "duplicates": ..,
/// "scale": .., "divider": .., "repetition": .., "left_repetition": ..}, "loupe": {"repetition": ..,
/// "layers": .., "level": ..}}. placings counts since the start. "right" is there while the split view shows
/// dots (an unknown repetition is null), "loupe" while the lens shows something.
nlohmann::ordered_json status_json(const StatusInfo& info, std::uint64_t placings);

/// Says "ready" on the standard output once something is shown, and then, if it was asked for, a line of JSON
/// whenever something in the window changed: what the document tells, and what both kinds have:
/// {"longest_frame_ms": .., "longest_work_ms": .., "gl_errors": .., "mouse": [x, y], "mouse_down": ..,
/// "row_with_keys": .., "widgets": {"Dots in black": [x0, y0, x1, y1], ..}}, places in window coordinates.
/// row_with_keys is a number of its own for each row, 0 for none.
class StatusLog {
 public:
    explicit StatusLog(bool all) : all_(all) {}

    bool ready() const { return ready_; }
    /// What the window took for a frame, from the events it knew to showing it, and of that its own processor
    /// time: the machine does other things too. The first frame, which makes everything ready, is left out.
    void took(double frame_ms, double work_ms);
    /// After each frame: what the document tells; none before something is shown.
    void write(std::optional<nlohmann::ordered_json> status, const WidgetNotes& widgets);

 private:
    bool all_, ready_ = false;
    int frames_ = 0;
    double longest_frame_ms_ = 0, longest_work_ms_ = 0;
    int gl_errors_ = 0;
    std::string written_;
};

}  // namespace dapple
