#include "core/drawing/gcode_choice.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/drawing/write_drawing.h"

namespace dapple {

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

GcodeProgram program_for(Machine machine, const DrawingToSave& drawing) {
    const SavingChoice& saving = drawing.file.saving;
    const std::vector<CutMark> marks = registration_of(drawing);
    if (drawing.file.format == DrawingFormat::gcode)
        return program_of({.size = drawing.page,
                           .dot_radius_mm = drawing.dot_radius_mm,
                           .pens = drawing.pens,
                           .registration = marks,
                           .gcode = gcode_style_of(saving)},
                          saving.tool, saving.acceleration_mm_per_s2);
    GcodeProgram result{.program = program_of(machine)};
    result.program.registration = marks;
    return result;
}

DrawingFacts::Gcode gcode_facts(const GcodeProgram& gcode, double segments, double drawing_s) {
    DrawingFacts::Gcode facts{.uncounted = gcode.uncounted,
                              .no_time = gcode.no_time,
                              .milliseconds = gcode.is_marlin && gcode.p_of_dwell};
    if (segments > 0 && drawing_s > 0 && gcode.line_bytes > 0) {
        facts.lines_per_s = segments / drawing_s;
        facts.most_lines_per_s = kSerialBaud / 10.0 / gcode.line_bytes;  // ten bits a byte
    }
    return facts;
}

}  // namespace dapple
