#pragma once
// How the window looks: warm paper greys and one ink blue, in light, dark and high contrast, sizes in
// proportion to the text. Text on what is behind it has a contrast of 4.5:1 and more (WCAG 2.1,
// 1.4.3), and what shows a control or its state one of 3:1 (1.4.11).

#include <cstdint>
#include <filesystem>
#include <optional>

#include <glm/vec3.hpp>

#include "core/text/names.h"

namespace dapple {

enum class ThemeColour { surround, panel, track, line, off, text, quiet, accent, warning };
enum class Theme { light, dark, high_contrast };
constexpr auto names_of(Theme) {
    return names("light", "dark", "high_contrast");
}

/// What people choose of it.
struct Appearance {
    Theme theme = Theme::light;
    float text_size = 1;  // times the usual one, 0.75..2

    bool operator==(const Appearance&) const = default;
};
inline constexpr float kSmallestText = 0.75f, kLargestText = 2;

/// Those of the theme applied last. As ImGui packs colours.
std::uint32_t colour_of(ThemeColour colour);
/// Such a colour with another opacity, 0..255.
std::uint32_t with_opacity(std::uint32_t colour, std::uint32_t opacity);
/// As the shaders take them, 0..1.
glm::vec3 rgb_of(ThemeColour colour);

/// The file of a system font for a fontconfig pattern such as "sans-serif:bold"; none if there is no font.
std::optional<std::filesystem::path> find_font(const char* pattern);

/// Whether it is a whole TrueType or OpenType file with letters and their outlines (ISO/IEC 14496-22). Dear
/// ImGui ends the program over any other, such as a bitmap font.
bool is_outline_font(const std::filesystem::path& file);

/// Loads fonts and sets ImGui's style for a content scale (1: 96 dpi). To be called between frames; sets up
/// anew when called again.
void apply_theme(const Appearance& appearance, float content_scale);

/// Bold, where the system has it.
void push_title_font();
void pop_title_font();

}  // namespace dapple
