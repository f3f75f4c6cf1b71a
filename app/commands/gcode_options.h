#pragma once
// The options of G-code: --gcode, --feed, --dwell, --acceleration.

#include "core/drawing/settings.h"

namespace CLI {
class App;
}

namespace dapple {

/// The options have to live until the command line is parsed.
void add_gcode_options(CLI::App& command, SavingChoice& saving);

/// What a template for --gcode is, for the end of the command's help.
const char* gcode_help();

}  // namespace dapple
