#pragma once
// What a machine does that reads G-code of some style: its template's lines, read as the machine reads them.

#include <string>
#include <vector>

#include "core/output/gcode.h"
#include "core/output/machine_clock.h"

namespace dapple {

struct GcodeProgram {
    MachineProgram program = {};
    std::vector<std::string> uncounted = {};  // words that move the machine in a way not followed here: G28
    bool no_time = false;                     // at a dot the tool is turned there and back again at once
    bool is_marlin = false;   // which alone turns a servo by M280, and rests by milliseconds after G4 P
    bool p_of_dwell = false;  // {dwell}, in seconds, stands after G4 P
    double line_bytes = 0;    // of each point of a line, about
};

/// Reads G0, G1, G4, G90, G91, F, X, Y, Z, and M words, all of which wait until the machine rests.
/// A Z axis moves at the same acceleration. G4 P is rounded as Grbl does it, G4 S is as it stands.
GcodeProgram program_of(const GcodeStyle& style, GcodeTool tool, double acceleration, const PageSize& page);

}  // namespace dapple
