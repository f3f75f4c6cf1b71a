#pragma once
// The rows by keyboard: Tab and Shift+Tab walk them in the order in which they are drawn, a ring shows which
// one has the keys, Escape or a press of the mouse lets go of it.
//
// Rows that are greyed are passed over. While a text is typed elsewhere, and under an open dialog or list, no
// row has the keys; nor has one that was not drawn in the frame before.

#include <imgui.h>

namespace dapple {

/// What the keys ask of the row that has them; all false of any other.
struct RowKeys {
    bool focused = false;
    bool press = false;  // Space or Enter
    bool enter = false;  // Enter alone: type the value
    bool reset = false;  // Backspace: the usual value again
    double step = 0;     // arrows, 1 to the right or up; with Shift ten, with Alt a tenth
};

/// Makes the place from `low` to `high`, in window coordinates, one stop on Tab's way through this ImGui
/// window; called once a frame while it is drawn. `name` tells it from the others under the current ID.
/// `typing`: a text in it has the keyboard. The stop then has the keys, and Tab walks on from it: to be
/// focused is false, and the text is to be left.
RowKeys row_keys(const char* name, ImVec2 low, ImVec2 high, bool typing = false);

/// The same for the item drawn last.
RowKeys item_keys(const char* name, bool typing = false);

/// Whether any row of this ImGui window has the keys.
bool a_row_has_keys();

/// An ImGui button that Space and Enter press too.
bool key_button(const char* label, ImVec2 size = {0, 0});

/// What notes in WidgetPlaces that a row has the keys: its place.
inline constexpr char kRowWithKeys[] = "Row with keys";

}  // namespace dapple
