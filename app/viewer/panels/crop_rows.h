#pragma once
// What of the picture is drawn, and how it is turned: rows of the section "Picture".

#include <glm/vec2.hpp>
#include <optional>

#include "core/drawing/page_setup.h"

namespace dapple {

/// True when the quarter turns changed.
bool draw_rotate_row(int& quarter_turns);

/// What of a picture of so many pixels is drawn, in percent of its width and height; `framing`: whether the
/// frame over the canvas is there. True when the crop changed.
bool draw_crop_rows(std::optional<Crop>& crop, glm::ivec2 picture, bool& framing);

}  // namespace dapple
