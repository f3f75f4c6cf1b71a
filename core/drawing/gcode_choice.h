#pragma once
// How the chosen G-code is written, and how a machine then moves.

#include "core/drawing/settings.h"
#include "core/output/drawing_format.h"
#include "core/output/gcode.h"
#include "core/output/plotting_time.h"

namespace dapple {

/// Throws std::runtime_error if the pen is up where it is down: it would draw on its way between dots.
void check_heights(const SavingChoice& saving);

/// Throws what parse_gcode_template() throws.
GcodeStyle gcode_style_of(const SavingChoice& saving);

/// How a machine moves that draws such a file. One that reads G-code goes at the feed and rests as long as
/// Grbl does where that says so (grbl_rest_s()): at each dot, or after the servo's turns; a Z axis goes from
/// one of the pen's heights to the other. What a template of one's own does between dots is taken as
/// `machine` has it. Others move as their programs do. Throws what parse_gcode_template() throws.
MachineSpeeds speeds_for(Machine machine, DrawingFormat format, const SavingChoice& saving);

}  // namespace dapple
