#pragma once
// Settings that a command draws with from elsewhere, and the masks beside them: what `dapple render` and
// `dapple record` have in common.

#include <CLI/CLI.hpp>
#include <functional>

#include "core/drawing/settings.h"
#include "io/files/picture.h"
#include "io/settings/embedded_settings.h"

namespace dapple {

/// --settings-from and --preset, which give `take` their settings; a preset's with what is the present
/// picture's own. To be added before the options that change them.
void add_settings_options(CLI::App& command, const DrawingSettings& present,
                          const std::function<void(const SavedSettings& settings)>& take);

/// --mask and --finer. Pictures of theirs may be as large as the limit says once they are read.
void add_mask_options(CLI::App& command, Mask& mask, const PictureLimit& limit);

/// Throws CLI::ValidationError if --finer has no effect on the drawing.
void check_finer(const CLI::App& command, const DrawingSettings& drawing);

}  // namespace dapple
