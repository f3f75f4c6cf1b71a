#pragma once
// The section "View": what is shown on the canvas beside the dots.

#include "app/viewer/model/viewer_settings.h"

namespace dapple {

/// True while something changes.
bool draw_view_panel(ViewerSettings& settings);

}  // namespace dapple
