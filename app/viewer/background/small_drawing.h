#pragma once
// What settings make of a picture, small: the preview of a preset.

#include <stop_token>

#include "app/viewer/background/small_pictures.h"
#include "core/drawing/settings.h"

namespace dapple {

/// The whole page, its longer side so many pixels. The picture is sRGB-encoded, as the window shows it, and
/// may be a small copy. Dots are relaxed once at most, which nobody can tell at such a size. Empty if
/// stopped. Throws as Workbench::place().
SmallPicture small_drawing(const SmallPicture& picture, DrawingSettings settings, int longer_side,
                           const std::stop_token& stop);

}  // namespace dapple
