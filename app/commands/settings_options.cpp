#include "app/commands/settings_options.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "io/command_line/options.h"
#include "io/command_line/remarks.h"
#include "io/settings/presets.h"

namespace dapple {

void add_settings_options(CLI::App& command, const DrawingSettings& present,
                          const std::function<void(const SavedSettings& settings)>& take) {
    command
        .add_option_function<std::string>(
            "--settings-from", [take](const std::string& file) { take(settings_from(file)); },
            "Draw with the settings of a project, or of a drawing (.svg, .png) that Dapple made; the other "
            "options change them")
        ->type_name("FILE");
    const auto read_preset = [take, &present](const std::string& name) {
        SavedSettings preset = preset_named(name, presets_folder()).settings;
        preset.drawing = with_preset(preset.drawing, present);
        take(preset);
    };
    command
        .add_option_function<std::string>("--preset", read_preset,
                                          "Draw with the settings of a preset; the other options change "
                                          "them. `dapple presets` lists the presets")
        ->type_name("PRESET")
        ->excludes("--settings-from");
}

void add_mask_options(CLI::App& command, Mask& mask, const PictureLimit& limit) {
    const auto light_of = [&limit](const char* option, const std::string& file) {
        try {
            return read_with_remark(file, limit).light;
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(fmt::format("{}: {}", option, error.what()));
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
            "A grey picture laid over the whole picture, before it is cropped or turned: middle grey "
            "(#808080) changes nothing, darker gives fewer dots, black none, lighter more, white four times "
            "as many where the tone leaves room; kept with 512 pixels along its longer side. none: drops the "
            "mask of the project")
        ->type_name("FILE|none")
        ->group("Tone");
    command
        .add_option_function<std::string>(
            "--finer", read_finer,
            "A grey picture laid over the picture as --mask is: black changes nothing, lighter gives more "
            "and "
            "smaller dots at the same tone, white four times as many of half the width. none: drops what the "
            "project or --mask has of it")
        ->type_name("FILE|none")
        ->group("Tone");
}

void check_finer(const CLI::App& command, const DrawingSettings& drawing) {
    if (drawing.mask.has_finer() && !can_be_finer(drawing))
        refuse(command, {"--finer"},
               "makes dots smaller, which lines and dots as wide as their pen cannot be; leave it out");
}

}  // namespace dapple
