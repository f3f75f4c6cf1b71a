#pragma once
// Dots as G-code, for plotters with a pen lift, and lasers: a template says what the machine does at a dot.
//
// A template is a text of lines that begin with what they are for. Lines of one kind are written in their
// order, without that first word; blank lines and those that begin with # are skipped:
//
//     start G21                   once, before all dots
//     move  G1 X{x} Y{y}          for each dot: the tool's way there
//     dot   M3 S90                for each dot: the tool makes it
//     dot   G4 P{dwell}
//     end   M5                    once, after all dots
//
// Where several pens draw there is also, before the dots of each,
//
//     pen   M0 ({pen} {name})     the machine waits until that pen is in it
//
// Where lines are drawn there are, after `move` to where one begins,
//
//     down  M3 S90                the tool begins to draw,
//     line  G1 X{x} Y{y}          goes to each next point,
//     up    M5                    and ends.
//
// {pen} is the pen's number from 1 and {name} its name, with [ and ] for ( and ), which end a comment. {x}
// and {y} are the dot's or point's place in millimetres from the page's lower left corner, {radius} its
// radius; {feed}, {dwell}, {up}, {down} and {power} are numbers of GcodeStyle. {burn} is the feed at which
// kBurstMm take as long as the dwell.

#include <string>
#include <string_view>
#include <vector>

#include "core/output/plotting_time.h"
#include "core/text/names.h"

namespace dapple {

struct InkPage;

enum class GcodeTool {
    pen,    // moved up and down by the Z axis
    servo,  // a pen on a servo that M3 turns, as on plotters that run Grbl
    laser,  // a burst for each dot
};
constexpr auto names_of(GcodeTool) {
    return names("pen", "servo", "laser");
}

/// Where the pen is off the paper and on it: of a Z axis in millimetres, of a servo the S that M3 turns it
/// to.
struct GcodeHeights {
    double up = 2, down = 0;
};

/// Those of a Z axis, or of a servo: 20 is up and 90 down on many. A laser has none.
GcodeHeights usual_heights(GcodeTool tool);

/// Grbl 1.1 rests by steps of so many seconds and rounds up to them (DWELL_TIME_STEP in its config.h), so
/// that G4 cannot time anything shorter. Others that read G4 P in seconds, such as LinuxCNC, do not round;
/// Marlin reads milliseconds there, and seconds as S.
inline constexpr double kGrblRestStepS = 0.05;
double grbl_rest_s(double dwell_s);

/// A laser's bursts that are shorter than that are moves over so many millimetres, to the right, with the
/// beam on: a few steps of a motor, and less than a beam is wide.
inline constexpr double kBurstMm = 0.05;
bool bursts_move(GcodeTool tool, double dwell_s);
/// Millimetres a minute at which it takes that long.
double burst_feed(double dwell_s);

/// The template of a kind of machine, as text. A laser burns a dot by M3 for as long as G4 rests; a short
/// burst by M4, with which Grbl in laser mode ($32=1) has the beam on only as long as it moves, and its
/// power by the speed, so that each dot gets what the dwell says however the machine gains speed.
std::string_view gcode_template_of(GcodeTool tool, double dwell_s = 0.1);

/// What stands in a line for something else, or text as it is.
struct GcodePiece {
    enum class Kind { text, x, y, radius, feed, dwell, burn, up, down, power, pen, name } kind = Kind::text;
    std::string text = {};

    bool operator==(const GcodePiece&) const = default;
};

/// Each part with its line ends.
struct GcodeTemplate {
    std::vector<GcodePiece> start, each_dot, end;
    std::vector<GcodePiece> move = {}, down = {}, line = {},
                            up = {};   // for strokes; each_dot has the move too
    std::vector<GcodePiece> pen = {};  // for several

    bool operator==(const GcodeTemplate&) const = default;
};

/// Throws std::runtime_error naming the line that is wrong: "line 3: ...".
GcodeTemplate parse_gcode_template(std::string_view text);

struct GcodeStyle {
    GcodeTemplate lines = parse_gcode_template(gcode_template_of(GcodeTool::pen));
    double feed_mm_per_min = 3000;
    double dwell_s = 0.1;
    GcodeHeights heights = {};
    double laser_power = 250;  // the S of its M3 or M4: of Grbl's usual 1000 ($30), a quarter
};

// What a machine does that reads G-code of some style: its template's lines, read as the machine reads them.

struct GcodeProgram {
    MachineProgram program = {};
    std::vector<std::string> uncounted = {};  // words that move the machine in a way not followed here: G28
    bool no_time = false;                     // at a dot the tool is turned there and back again at once
    bool is_marlin = false;   // which alone turns a servo by M280, and rests by milliseconds after G4 P
    bool p_of_dwell = false;  // {dwell}, in seconds, stands after G4 P
    double line_bytes = 0;    // of each point of a line, about
};

/// Reads G0, G1, G4, G90, G91, F, X, Y, Z, and M words, all of which wait until the machine rests.
/// A Z axis moves at the same acceleration. G4 P is rounded as Grbl does it, G4 S is as it stands. Of the
/// page count its size, its pens with their registration, its style and the radius of all dots.
GcodeProgram program_of(const InkPage& page, GcodeTool tool, double acceleration);

}  // namespace dapple
