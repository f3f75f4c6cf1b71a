#pragma once
// How far a file is written, or something like it, and the button that stops it.

#include <glm/vec2.hpp>
#include <string>

namespace dapple {

/// A bar at the bottom of the canvas that tells how far the saving of a file is, 0..1. True when its Cancel
/// was clicked.
bool draw_saving_banner(const std::string& file_name, double share, glm::vec2 corner, glm::vec2 size);

/// The same while a picture is read, of which nobody knows how far it is.
bool draw_opening_banner(const std::string& name, glm::vec2 corner, glm::vec2 size);

/// And while an environment map is sampled.
bool draw_sampling_banner(double share, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
