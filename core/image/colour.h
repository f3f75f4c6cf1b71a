#pragma once
// Ink and paper: sRGB-encoded colours, components 0..1, and the way people write them, #rrggbb.

#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace dapple {

inline constexpr glm::vec3 kBlack{0, 0, 0};
inline constexpr glm::vec3 kWhite{1, 1, 1};

/// "#1a2b3c" or "#fff", upper or lower case, the # may be left out. Throws std::runtime_error if it is
/// neither.
glm::vec3 parse_colour(std::string_view text);

/// "#1a2b3c"; components are clamped.
std::string hex_of(glm::vec3 colour);

/// What a pen of that colour is called on a layer: "Black", "White", or the hex form.
std::string pen_name(glm::vec3 colour);

/// The colour that tells a level of the subdivision from the ones beside it, on paper and on screen.
glm::vec3 level_colour(int level);

}  // namespace dapple
