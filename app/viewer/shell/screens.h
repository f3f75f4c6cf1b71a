#pragma once
// Where a window lies among the screens of a desktop, all in the desktop's units.

#include <cstddef>
#include <span>

#include "core/image/rectangle.h"

namespace dapple {

/// Whether a person can take hold of the window by its title bar, of which a part is on some screen.
bool is_within_reach(const Rectangle<int>& window, std::span<const Rectangle<int>> screens);

/// Which screen most of the window is on; the first where it is on none.
std::size_t screen_under(const Rectangle<int>& window, std::span<const Rectangle<int>> screens);

}  // namespace dapple
