#pragma once
// How far a file has been written, or other long work has come, and the button that stops it.

#include <glm/vec2.hpp>
#include <string>

namespace dapple {

/// A bar at the bottom of the canvas that tells how far the saving of a file has come, 0..1. True when its
/// Cancel was clicked.
bool draw_saving_banner(const std::string& file_name, double share, glm::vec2 corner, glm::vec2 size);

/// The same while a picture is read; nobody knows how far that has come.
bool draw_opening_banner(const std::string& name, glm::vec2 corner, glm::vec2 size);

/// And while an environment map is sampled.
bool draw_sampling_banner(double share, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
