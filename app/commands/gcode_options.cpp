#include "app/commands/gcode_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "io/command_line/options.h"
#include "io/files/gcode_template.h"

namespace dapple {
namespace {

// A tool by its name, or a template of one's own.
void take_tool(SavingChoice& saving, const std::string& text) {
    saving.gcode_template = {};
    if (const auto tool = value_named<GcodeTool>(text)) {
        saving.tool = *tool;
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
            "M3; laser: a burst by M3, a short one by M4; or a template of your own, see below")
        ->type_name("pen|servo|laser|FILE")
        ->default_str("pen")
        ->group("G-code");
    for (CLI::Option* const option :
         {add_number(command, setting::feed, saving.feed_mm_per_min),
          add_number(command, setting::dwell, saving.dwell_s),
          add_number(command, setting::acceleration, saving.acceleration_mm_per_s2),
          add_number(command, setting::pen_up, saving.pen_up),
          add_number(command, setting::pen_down, saving.pen_down),
          add_number(command, setting::laser_power, saving.laser_power)})
        option->group("G-code");
}

const char* gcode_help() {
    return "A template for --gcode is a text whose lines begin with start, move, dot or end: what is written "
           "once "
           "before the dots, for the way to each dot, at each dot, and once after them. {x} and {y} stand "
           "for the "
           "dot's place in mm from the lower left corner, {radius} for its radius, {feed}, {dwell}, {up}, "
           "{down} and {power} for the options, {burn} for the feed at which 0.05 mm take as long as the "
           "dwell. For lines to draw, lines that begin with down, line and up "
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
