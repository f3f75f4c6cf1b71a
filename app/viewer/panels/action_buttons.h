#pragma once
// The title above the sections, its menu and the buttons.

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// The name of what is shown, and at the end of its line a menu of what is asked for seldom: all commands,
/// keys, preferences, about the program.
void draw_title(const std::string& name, const std::function<void(Action)>& act);

/// The menu that a right click opens in a rectangle which no ImGui window covers: views of the drawing, and
/// where it goes.
void draw_canvas_menu(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act);

/// What the buttons would undo and do again, in words; none: nothing.
struct UndoInfo {
    std::optional<std::string> undo, redo;
};

/// `has_project`: there are settings to be saved with the picture.
void draw_action_buttons(const UndoInfo& info, bool has_project, const std::function<void(Action)>& act);

}  // namespace dapple
