#pragma once
// The dialogs about the program itself: how it looks, and what it is.

#include "app/viewer/widgets/theme.h"
#include "core/text/length.h"

namespace dapple {

/// Theme and size of the text, whether the desktop's own dialog asks for files to open, and the unit that the
/// document shows lengths in; none: it shows none. True when something was changed but that unit, which is
/// the document's.
bool draw_preferences(Appearance& appearance, bool& desktop_dialog, LengthUnit* unit);
/// The same in a dialog.
bool draw_preferences_panel(bool& open, Appearance& appearance, bool& desktop_dialog, LengthUnit* unit);

/// Version, licence, and the libraries it stands on with theirs.
void draw_about_panel(bool& open);

}  // namespace dapple
