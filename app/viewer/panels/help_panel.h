#pragma once
// The list of keys.

#include <span>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// The list of keys over everything else, while `open`; a click outside or Escape closes it.
void draw_help_panel(bool& open, std::span<const Shortcut> shortcuts);

}  // namespace dapple
