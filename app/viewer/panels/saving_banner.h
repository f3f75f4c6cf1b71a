#pragma once
// How far a file is written, and the button that stops it.

#include <glm/vec2.hpp>
#include <string>

namespace dapple {

/// A bar at the bottom of the canvas that tells how far the saving of a file is, 0..1. True when its Cancel
/// was clicked.
bool draw_saving_banner(const std::string& file_name, double share, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
