#pragma once
// The crop as the window edits it: in percent of the picture, whatever unit it came in.

#include <glm/vec2.hpp>
#include <optional>

#include "core/drawing/page_setup.h"

namespace dapple {

/// The window makes none narrower or lower.
inline constexpr double kLeastCropPercent = 1;

/// The crop in percent of a picture of so many pixels; none is all of it.
Rectangle<double> crop_percent(const std::optional<Crop>& crop, glm::ivec2 picture);
/// In percent, kept within the picture and so wide and high as that; all of the picture is none.
std::optional<Crop> crop_of_percent(Rectangle<double> box);

}  // namespace dapple
