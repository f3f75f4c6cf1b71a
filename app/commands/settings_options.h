#pragma once
// Settings that a command draws with from elsewhere, and the masks beside them: what `dapple render` and
// `dapple record` have in common.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>

#include "core/drawing/settings.h"
#include "io/files/picture.h"
#include "io/settings/project.h"

namespace dapple {

// A project as the command line draws it.

struct ProjectInput {
    std::optional<std::filesystem::path> picture;  // none: the built-in sample
    DrawingSettings drawing;
    SavingChoice saving;
};

/// Throws std::runtime_error naming the file if it cannot be read, or shows a plain density, which the window
/// alone draws.
ProjectInput read_project_input(const std::filesystem::path& file);

// The options of G-code: --gcode, --feed, --dwell, --acceleration.

/// The options have to live until the command line is parsed.
void add_gcode_options(CLI::App& command, SavingChoice& saving);

/// What a template for --gcode is, for the end of the command's help.
const char* gcode_help();

/// --settings-from and --preset, which give `take` their settings; a preset's with what is the present
/// picture's own. To be added before the options that change them.
void add_settings_options(CLI::App& command, const DrawingSettings& present,
                          const std::function<void(const SavedSettings& settings)>& take);

/// --mask and --finer. Pictures of theirs may be as large as the limit says once they are read.
void add_mask_options(CLI::App& command, Mask& mask, const PictureLimit& limit);

/// Throws CLI::ValidationError if --finer has no effect on the drawing.
void check_finer(const CLI::App& command, const DrawingSettings& drawing);

}  // namespace dapple
