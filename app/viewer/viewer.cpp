#include "app/viewer/viewer.h"

#include <memory>

#include "app/viewer/shell/drawing_document.h"
#include "app/viewer/shell/lights_document.h"
#include "app/viewer/shell/shell.h"
#include "io/files/tile_library.h"
#include "io/settings/palettes.h"
#include "io/settings/presets.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

static Memory memory_of_person(const auto& options) {
    Memory memory = options.fresh ? Memory() : Memory(config_folder(), state_folder());
    if (options.own_dialog) memory.preferences.dialog = DialogChoice::own;
    return memory;
}

int run_viewer(const ViewerOptions& options) {
    if (options.tile) load_tile(*options.tile);
    Shell shell(options.log_status, memory_of_person(options),
                options.fresh ? "" : within_folder(state_folder(), "unsaved"));
    return shell.run(
        std::make_unique<DrawingDocument>(options.image, options.tile, shell.memory().state.view,
                                          options.fresh ? "" : within_folder(config_folder(), "presets"),
                                          options.fresh ? "" : within_folder(config_folder(), "palettes")));
}

int run_viewer(const LightViewerOptions& options) {
    load_tile(options.settings.tile);
    Shell shell(options.log_status, memory_of_person(options));
    return shell.run(std::make_unique<LightsDocument>(options.map, options.settings));
}

}  // namespace dapple
