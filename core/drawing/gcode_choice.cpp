#include "core/drawing/gcode_choice.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

namespace {

// How long {dwell} rests in these lines, in seconds: rounded as Grbl does after G4 P, as it is after other
// words.
double rests_s(std::span<const GcodePiece> lines, double dwell_s) {
    double seconds = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].kind != GcodePiece::Kind::dwell) continue;
        const bool rounded = i > 0 && lines[i - 1].text.ends_with("G4 P");
        seconds += rounded ? grbl_rest_s(dwell_s) : dwell_s;
    }
    return seconds;
}

}  // namespace

GcodeStyle gcode_style_of(const SavingChoice& saving) {
    const std::string_view text = saving.gcode_template.text.empty()
                                      ? gcode_template_of(saving.tool, saving.dwell_s)
                                      : saving.gcode_template.text;
    const GcodeHeights usual = usual_heights(saving.tool);
    return {.lines = parse_gcode_template(text),
            .feed_mm_per_min = saving.feed_mm_per_min,
            .dwell_s = saving.dwell_s,
            .heights = {saving.pen_up.value_or(usual.up), saving.pen_down.value_or(usual.down)},
            .laser_power = saving.laser_power};
}

void check_heights(const SavingChoice& saving) {
    const GcodeStyle style = gcode_style_of(saving);
    const auto names = [](const std::vector<GcodePiece>& pieces, GcodePiece::Kind kind) {
        return std::ranges::find(pieces, kind, &GcodePiece::kind) != pieces.end();
    };
    const std::vector<GcodePiece>& dot = style.lines.each_dot;
    if (!names(dot, GcodePiece::Kind::up) || !names(dot, GcodePiece::Kind::down)) return;
    if (style.heights.up != style.heights.down) return;
    throw std::runtime_error(fmt::format(
        "the pen is up at {0:g} and down at {0:g}, so it would never be lifted; give it two heights",
        style.heights.up));
}

MachineSpeeds speeds_for(Machine machine, DrawingFormat format, const SavingChoice& saving) {
    MachineSpeeds speeds = speeds_of(machine);
    if (format != DrawingFormat::gcode) return speeds;
    const GcodeStyle style = gcode_style_of(saving);
    speeds.top_speed = speeds.drawing_speed = saving.feed_mm_per_min / 60;
    speeds.acceleration = speeds.drawing_acceleration = saving.acceleration_mm_per_s2;
    speeds.dot_s = rests_s(style.lines.each_dot, saving.dwell_s);
    if (!saving.gcode_template.text.empty()) return speeds;
    switch (saving.tool) {
        case GcodeTool::pen:
            speeds.lower_s = speeds.raise_s =
                move_time(std::abs(style.heights.up - style.heights.down), speeds);
            break;
        case GcodeTool::servo:  // it rests for each of them
            speeds.lower_s = rests_s(style.lines.down, saving.dwell_s);
            speeds.raise_s = rests_s(style.lines.up, saving.dwell_s);
            speeds.dot_s = 0;
            break;
        case GcodeTool::laser:
            speeds.lower_s = speeds.raise_s = 0;
            if (bursts_move(saving.tool, saving.dwell_s)) {
                MachineSpeeds burning = speeds;
                burning.top_speed = burst_feed(saving.dwell_s) / 60;
                speeds.dot_s = move_time(kBurstMm, burning);
            }
            break;
    }
    return speeds;
}

}  // namespace dapple
