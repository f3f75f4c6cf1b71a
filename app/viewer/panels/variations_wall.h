#pragma once
// Nine small drawings in the canvas's place: the one there is in the middle, and others around it. A click
// takes one, which is in the middle then, with others around it again.

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "app/viewer/model/variations.h"
#include "app/viewer/widgets/picture_entry.h"

namespace dapple {

/// `preview`: what settings make of the picture, small. The one that was clicked; the middle one ends the
/// choice.
std::optional<std::size_t> draw_variations(const std::array<Variation, 9>& variations,
                                           const std::function<EntryPicture(const DrawingSettings&)>& preview,
                                           glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
