#pragma once
// The dialogs about the program itself: how it looks, and what it is.

#include "app/viewer/widgets/theme.h"

namespace dapple {

/// Theme and size of the text, and whether the desktop's own dialog asks for files to open. True when
/// something was changed.
bool draw_preferences(Appearance& appearance, bool& desktop_dialog);
/// The same in a dialog.
bool draw_preferences_panel(bool& open, Appearance& appearance, bool& desktop_dialog);

/// Version, licence, and the libraries it stands on with theirs.
void draw_about_panel(bool& open);

}  // namespace dapple
