#pragma once
// Ink and paper: sRGB-encoded colours, components 0..1, and the way people write them, #rrggbb.

#include <glm/gtc/packing.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "core/export.h"
#include "core/image/grid.h"
#include "core/image/tone.h"

namespace dapple {

// Colours as light: linear components with the primaries of sRGB, 0 dark, 1 as light as paper.

/// From an sRGB-encoded colour to linear light, and back.
inline glm::vec3 linear_of(glm::vec3 encoded) {
    return {srgb_to_linear(encoded.r), srgb_to_linear(encoded.g), srgb_to_linear(encoded.b)};
}
inline glm::vec3 encoded_of(glm::vec3 linear) {
    return {linear_to_srgb(linear.r), linear_to_srgb(linear.g), linear_to_srgb(linear.b)};
}
inline glm::u8vec3 srgb_bytes(glm::vec3 linear) {
    return {srgb_byte(linear.r), srgb_byte(linear.g), srgb_byte(linear.b)};
}

/// The luminance of linear light, by Rec. 709 weights.
inline float luminance(glm::vec3 linear) {
    return 0.2126f * linear.r + 0.7152f * linear.g + 0.0722f * linear.b;
}

/// A picture's colours, each component a half float: light over paper white too, in half the memory.
using ColourGrid = Grid<glm::u16vec3>;

inline glm::u16vec3 packed(glm::vec3 linear) {
    return {glm::packHalf1x16(linear.r), glm::packHalf1x16(linear.g), glm::packHalf1x16(linear.b)};
}
inline glm::vec3 unpacked(glm::u16vec3 colour) {
    return {glm::unpackHalf1x16(colour.r), glm::unpackHalf1x16(colour.g), glm::unpackHalf1x16(colour.b)};
}

inline constexpr glm::vec3 kBlack{0, 0, 0};
inline constexpr glm::vec3 kWhite{1, 1, 1};

/// "#1a2b3c" or "#fff", upper or lower case, the # may be left out. Throws std::runtime_error if it is
/// neither.
DAPPLE_API glm::vec3 parse_colour(std::string_view text);

/// "#1a2b3c"; components are clamped.
DAPPLE_API std::string hex_of(glm::vec3 colour);

/// What a pen of that colour is called on a layer: "Black", "White", or the hex form.
DAPPLE_API std::string pen_name(glm::vec3 colour);

/// The colour that tells a level of the subdivision from the ones beside it, on paper and on screen.
glm::vec3 level_colour(int level);

}  // namespace dapple
