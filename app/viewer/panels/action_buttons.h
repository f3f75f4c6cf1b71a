#pragma once
// The title above the sections, its menu and the buttons.

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// What the column holds below its title: the drawing's settings, or one thing in their place.
enum class Column { drawing, crop, mask, method };

/// What would be undone and done again, in words; none: nothing.
struct UndoInfo {
    std::optional<std::string> undo, redo;
};

/// The name of what is shown, and at the end of its line small buttons: undo, redo, fit, and a menu of what
/// is asked for seldom: all commands, keys, preferences, about the program.
void draw_title(const std::string& name, const UndoInfo& info, const std::function<void(Action)>& act);

/// The menu that a right click opens in a rectangle which no ImGui window covers: views of the drawing, and
/// where it goes.
void draw_canvas_menu(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act);

/// Tools in a row over the canvas, from its corner on: crop, mask, rotate. The one that is in the column is
/// marked.
void draw_canvas_tools(glm::vec2 corner, Column column, const std::function<void(Action)>& act);

/// `has_project`: there are settings to be saved with the picture.
void draw_action_buttons(bool has_project, const std::function<void(Action)>& act);

}  // namespace dapple
