#pragma once
// The section "View": what is shown on the canvas, and in which colours.

#include "app/viewer/model/viewer_settings.h"

namespace dapple {

/// What is shown and in which colours. True while something changes.
bool draw_view_panel(ViewerSettings& settings);

}  // namespace dapple
