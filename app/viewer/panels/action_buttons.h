#pragma once
// The buttons at the top of the column.

#include <functional>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// The row "Open...", "Export...", "Keys".
void draw_action_buttons(const std::function<void(Action)>& act);

}  // namespace dapple
