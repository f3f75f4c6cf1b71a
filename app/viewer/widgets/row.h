#pragma once
// What every row is made of: its label, its keys, its tip, its place in a list of all rows. For the files
// beside this one alone; panels know widgets.h.

#include <imgui.h>
#include <cstddef>
#include <optional>
#include <span>

#include "app/viewer/widgets/widgets.h"
#include "core/settings/setting.h"

namespace dapple {

// The rows by keyboard: Tab and Shift+Tab walk them in the order in which they are drawn, a ring shows which
// one has the keys, Escape or a press of the mouse lets go of it.
//
// Rows that are greyed are passed over. While a text is typed elsewhere, and under an open dialog or list, no
// row has the keys; nor has one that was not drawn in the frame before.

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

inline constexpr float kLabelShare = 0.36f;  // of the row
inline constexpr float kLabelAir = 0.4f;     // in letters' heights: behind a label

struct Row {
    ImVec2 start;
    float width, height, control_x;
};

struct LabelLook {
    float control_width = 0;      // of one at the row's end; 0: it begins after the labels' column
    const char* shown = nullptr;  // none: the label itself
};

/// None without anyone to tell.
WidgetNotes* widget_notes();

/// Whether what would be drawn now is not there (see Absent).
bool is_left_out();

/// Where rows are listed or left out, whether the row took another value; none: it is to be drawn.
std::optional<bool> as_listed(const char* label, std::span<const char* const> names, int& chosen);
std::optional<bool> as_listed(const char* label);

/// Draws the label and leaves the cursor where the control begins. True if the label was double-clicked. In a
/// narrow window the label is cut off before the control.
bool begin_row(const char* label, Row& row, const LabelLook& look = {});
void end_row(const Row& row);

RowKeys keys_of(const char* label, const Row& row, bool typing = false);

/// Which of so many entries the arrows choose next.
int stepped(int chosen, double step, std::size_t entries);

/// Whether a tooltip may begin: one that appears beside a dialog, in the frame in which that opens, ends the
/// program by an assertion of ImGui's (see kNeverAsksForFocus, which a tooltip cannot have).
bool may_have_tooltip();
/// Round, whatever the window is that its row is in.
void begin_tooltip();

/// Where a tip stands.
struct TipPlace {
    enum class Side { left, above };
    ImVec2 point;
    Side side = Side::left;  // of the point, where there is room; it ends above what keep_tips_above() says
};

/// A tip, once the mouse has come to rest on what it is about; moving on must not make it flicker. Without a
/// place it stands at the mouse.
void show_tip(const char* text, bool hovered, const std::optional<TipPlace>& place = {});
/// Beside the row, so that it hides none of the next ones.
void show_row_tip(const char* text, const Row& row);

void close_on_escape();

}  // namespace dapple
