#include "app/commands/settings_options.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "app/commands/commands.h"
#include "core/failure.h"
#include "core/settings/drawing_fields.h"
#include "core/text/shown_text.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/text_file.h"
#include "io/settings/presets.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

ProjectInput read_project_input(const std::filesystem::path& file) {
    ProjectInput input;
    bool photograph = true;
    Project project = read_project(file, [&](Fields& fields) {
        describe_drawing(fields, input.drawing, input.saving);
        fields.group("density", [&](Fields& density) {
            density.choice(
                "source", photograph,
                {NamedValue{"photograph", true}, NamedValue{"grey", false}, NamedValue{"ramp", false}});
        });
    });
    if (!project.why_missing.empty()) throw std::runtime_error(project.why_missing);
    input.picture = std::move(project.picture);
    if (!photograph)
        throw std::runtime_error(printable(file.native()) +
                                 ": shows a plain density, which only the window draws; choose the "
                                 "photograph there, under The method, and save it again");
    return input;
}

namespace {

// A tool by its name, or a template of one's own.
void take_tool(SavingChoice& saving, const std::string& text) {
    saving.gcode_template = {};
    if (const auto tool = value_named<GcodeTool>(text)) {
        saving.tool = *tool;
        return;
    }
    std::error_code looped;  // reading it says so
    if (!std::filesystem::exists(text, looped) && !looped)
        throw failure("--gcode: {} is not pen, servo, laser or a file with a template", text);
    saving.gcode_template = read_gcode_template(text);
}

}  // namespace

void add_gcode_options(CLI::App& command, SavingChoice& saving) {
    command
        .add_option_function<std::string>(
            "--gcode", [&saving](const std::string& text) { take_tool(saving, text); },
            "G-code: what the machine does at a dot. pen: lowers it with the Z axis; servo: turns a servo "
            "(M3); laser: a burst by M3, or by M4 if short; or a custom template, see below")
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
    return "A template for --gcode is a text file whose lines begin with start, move, dot or end: what to "
           "write once before the dots, to move to each dot, at each dot, and once after them. {x} and {y} "
           "stand for the dot's position in mm from the lower left corner, {radius} for its radius, {feed}, "
           "{dwell}, {up}, {down} and {power} for the options, {burn} for the feed at which 0.05 mm take as "
           "long as the dwell. To draw lines, add lines that begin with down, line and up: what begins a "
           "stroke, leads to its next point, and ends it. A pen that a servo turns:\n"
           "  start G21\n"
           "  start G90\n"
           "  move G1 X{x} Y{y} F{feed}\n"
           "  dot M3 S90\n"
           "  dot G4 P{dwell}\n"
           "  dot M3 S20\n"
           "  end M5\n";
}

void add_settings_options(CLI::App& command, const DrawingSettings& present,
                          const std::function<void(const SavedSettings& settings)>& take) {
    command
        .add_option_function<std::string>(
            "--settings-from", [take](const std::string& file) { take(settings_from(file)); },
            "Uses the settings of a project, or of a drawing (.svg, .png) made with Dapple; the other "
            "options change them")
        ->type_name("FILE");
    const auto read_preset = [take, &present](const std::string& name) {
        SavedSettings preset = preset_named(name, within_folder(config_folder(), "presets")).settings;
        preset.drawing = with_preset(preset.drawing, present);
        take(preset);
    };
    command
        .add_option_function<std::string>("--preset", read_preset,
                                          "Uses the settings of a preset; the other options change them. "
                                          "`dapple presets` lists the presets")
        ->type_name("PRESET")
        ->excludes("--settings-from");
}

void add_mask_options(CLI::App& command, Mask& mask, const PictureLimit& limit) {
    const auto light_of = [&limit](const char* option, const std::string& file) {
        try {
            return read_with_remark(file, limit).light;
        } catch (const std::runtime_error& error) {
            throw failure("{}: {}", option, error.what());
        }
    };
    const auto read_mask = [&mask, light_of](const std::string& file) {
        mask = {};
        if (file != "none") mask = mask_of(light_of("--mask", file));
    };
    const auto read_finer = [&mask, light_of](const std::string& file) {
        mask = file == "none" ? mask.without_finer() : with_fineness(mask, light_of("--finer", file));
    };
    command
        .add_option_function<std::string>(
            "--mask", read_mask,
            "A grey picture laid over the whole picture, before crop and rotation: middle grey (#808080) "
            "changes nothing, darker gives fewer dots, black none, lighter more, white four times as many "
            "where the tone leaves room; kept with 512 pixels along its longer side. none: drops the "
            "project's mask")
        ->type_name("FILE|none")
        ->group("Tone");
    command
        .add_option_function<std::string>(
            "--finer", read_finer,
            "A grey picture laid over the picture like --mask: black changes nothing, lighter gives more and "
            "smaller dots at the same tone, white four times as many of half the width. none: drops the "
            "project's")
        ->type_name("FILE|none")
        ->group("Tone");
}

void check_finer(const CLI::App& command, const DrawingSettings& drawing) {
    if (drawing.mask.has_finer() && !can_be_finer(drawing))
        refuse(command, {"--finer"},
               "makes dots smaller, which lines and dots as wide as their pen cannot be; leave it out");
}

// Prints a line each: the name, a tab, what it is about.
void add_presets_command(CLI::App& program) {
    program
        .add_subcommand("presets",
                        "List the presets for render --preset: built-in ones and those that the window saved")
        ->callback([] {
            for (const Preset& preset : built_in_presets()) fmt::print("{}\t{}\n", preset.name, preset.about);
            for (const std::string& name : own_presets(within_folder(config_folder(), "presets")))
                fmt::print("{}\tyour preset\n", name);
        });
}

}  // namespace dapple
