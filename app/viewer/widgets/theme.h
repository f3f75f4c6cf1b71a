#pragma once
// How the window looks: warm paper greys and one ink blue, sizes in proportion to the text.

#include <cstdint>
#include <filesystem>
#include <optional>

#include <glm/vec3.hpp>

namespace dapple {

enum class ThemeColour { surround, panel, track, line, text, quiet, accent, warning };

/// As ImGui packs colours.
std::uint32_t colour_of(ThemeColour colour);
/// As the shaders take them, 0..1.
glm::vec3 rgb_of(ThemeColour colour);

/// The file of a system font for a fontconfig pattern such as "sans-serif:bold"; none if there is no font.
std::optional<std::filesystem::path> find_font(const char* pattern);

/// Loads fonts and sets ImGui's style for a content scale (1: 96 dpi). To be called between frames; sets up
/// anew when called again.
void apply_theme(float content_scale);

/// Bold, where the system has it.
void push_title_font();
void pop_title_font();

}  // namespace dapple
