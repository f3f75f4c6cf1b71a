#include "app/viewer/viewer.h"

#include <memory>

#include "app/files/tile_library.h"
#include "app/viewer/shell/drawing_document.h"
#include "app/viewer/shell/lights_document.h"
#include "app/viewer/shell/shell.h"

namespace dapple {

int run_viewer(const ViewerOptions& options) {
    if (options.tile) load_tile(*options.tile);
    Shell shell(options.log_status);
    return shell.run(std::make_unique<DrawingDocument>(options.image, options.tile));
}

int run_viewer(const LightViewerOptions& options) {
    load_tile(options.settings.tile);
    Shell shell(options.log_status);
    return shell.run(std::make_unique<LightsDocument>(options.map, options.settings));
}

}  // namespace dapple
