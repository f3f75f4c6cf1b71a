#pragma once
// How the chosen G-code is written, and how a machine then moves.

#include "core/drawing/drawing.h"
#include "core/drawing/settings.h"
#include "core/output/drawing_format.h"
#include "core/output/findings.h"
#include "core/output/gcode.h"

namespace dapple {

/// Throws std::runtime_error if the pen is up where it is down: it would draw on its way between dots.
void check_heights(const SavingChoice& saving);

/// Throws what parse_gcode_template() throws.
GcodeStyle gcode_style_of(const SavingChoice& saving);

/// What a machine does that draws the file. One that reads G-code does what the template's lines say;
/// others move as their programs do. Throws what parse_gcode_template() throws.
GcodeProgram program_for(Machine machine, const DrawingToSave& drawing);

/// What someone should know of the program, of a drawing of so many straight pieces of lines that take so
/// long.
DrawingFacts::Gcode gcode_facts(const GcodeProgram& gcode, double segments, double drawing_s);

}  // namespace dapple
