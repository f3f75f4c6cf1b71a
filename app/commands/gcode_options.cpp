#include "app/commands/gcode_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/commands/options.h"
#include "app/files/gcode_choice.h"

namespace dapple {
namespace {

// A tool by its name, or a template of one's own.
void take_tool(SavingChoice& saving, const std::string& text) {
    saving.gcode_template = {};
    for (const GcodeTool tool : {GcodeTool::pen, GcodeTool::servo, GcodeTool::laser}) {
        if (text != name_of(tool)) continue;
        saving.tool = tool;
        return;
    }
    std::error_code looped;  // reading it says so
    if (!std::filesystem::exists(text, looped) && !looped) {
        throw std::runtime_error(
            fmt::format("--gcode: {} is neither pen, servo nor laser, nor a file with a template", text));
    }
    saving.gcode_template = read_gcode_template(text);
}

}  // namespace

void add_gcode_options(CLI::App& command, SavingChoice& saving) {
    command
        .add_option_function<std::string>(
            "--gcode", [&saving](const std::string& text) { take_tool(saving, text); },
            "G-code: what the machine does at a dot. pen: lowers it by the Z axis; servo: turns a servo by "
            "M3; laser: a burst by M3; or a template of your own, see below")
        ->type_name("pen|servo|laser|FILE")
        ->default_str("pen")
        ->group("G-code");
    add_number(command, "--feed", saving.feed_mm_per_min, {.least = kSlowestFeed, .most = kFastestFeed},
               "MM/MIN", "G-code: how fast the tool moves, in millimetres a minute")
        ->group("G-code");
    add_number(command, "--dwell", saving.dwell_s, {.least = 0, .most = kLongestDwellS}, "SECONDS",
               "G-code: how long the tool rests at a dot, as G4 P, which Grbl and LinuxCNC read in seconds")
        ->group("G-code");
    add_number(
        command, "--acceleration", saving.acceleration_mm_per_s2,
        {.least = kLeastAcceleration, .most = kMostAcceleration}, "MM/S2",
        "G-code: how fast the machine gains speed, for the plotting time that is told. Grbl comes with 10, "
        "and machines are mostly set to 500 to 3000 ($120)")
        ->group("G-code");
    const NumberRange height{.least = -kMostHeight, .most = kMostHeight};
    add_number(
        command, "--pen-up", saving.pen_up, height, "Z|S",
        "G-code: where the pen is off the paper, Z in millimetres or the S of a servo; without it 2 or "
        "20")
        ->group("G-code");
    add_number(command, "--pen-down", saving.pen_down, height, "Z|S",
               "G-code: where the pen is on the paper; without it 0 or 90")
        ->group("G-code");
    add_number(command, "--laser-power", saving.laser_power, {.least = 0, .most = kMostLaserPower}, "S",
               "G-code: the S of a laser's M3; Grbl comes with 1000 for full power ($30)")
        ->group("G-code");
}

const char* gcode_help() {
    return "A template for --gcode is a text whose lines begin with start, move, dot or end: what is written "
           "once "
           "before the dots, for the way to each dot, at each dot, and once after them. {x} and {y} stand "
           "for the "
           "dot's place in mm from the lower left corner, {radius} for its radius, {feed}, {dwell}, {up}, "
           "{down} and {power} for the options. For lines to draw, lines that begin with down, line and up "
           "say what begins one, leads "
           "to each "
           "next point, and ends it. A pen that a servo turns:\n"
           "  start G21\n"
           "  start G90\n"
           "  move G1 X{x} Y{y} F{feed}\n"
           "  dot M3 S90\n"
           "  dot G4 P{dwell}\n"
           "  dot M3 S20\n"
           "  end M5\n";
}

}  // namespace dapple
