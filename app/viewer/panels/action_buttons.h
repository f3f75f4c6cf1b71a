#pragma once
// The buttons above the sections.

#include <functional>
#include <optional>
#include <string>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// What the buttons would undo and do again, in words; none: nothing.
struct UndoInfo {
    std::optional<std::string> undo, redo;
};

/// `has_project`: there are settings to be saved with the picture.
void draw_action_buttons(const UndoInfo& info, bool has_project, const std::function<void(Action)>& act);

}  // namespace dapple
