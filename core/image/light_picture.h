#pragma once
// A picture in memory, as light.

#include <cstdint>
#include <span>

#include "core/export.h"
#include "core/image/colour.h"
#include "core/image/grid.h"

namespace dapple {

/// Linear light with the primaries of sRGB: 0 is black, 1 as light as paper. Pictures of the outdoors may
/// have more.
struct LightPicture {
    Grid<float> light;        // luminance
    ColourGrid colours = {};  // of the same pixels, for several pens; empty: the picture is grey
};

/// Pixels as most programs have them: sRGB-encoded, of 8 or 16 bits a channel or as numbers from 0 to 1, row
/// after row from the top, without gaps. `channels`: 1 grey, 2 grey and alpha, 3 red, green and blue, 4 the
/// same and alpha. What is transparent shows white paper. Throws std::runtime_error if there are not
/// width * height * channels of them, or if a number is not within 0 to 1.
DAPPLE_API LightPicture picture_of_srgb(std::span<const std::uint8_t> pixels, int width, int height,
                                        int channels);
DAPPLE_API LightPicture picture_of_srgb(std::span<const std::uint16_t> pixels, int width, int height,
                                        int channels);
DAPPLE_API LightPicture picture_of_srgb(std::span<const float> pixels, int width, int height, int channels);

/// The same of linear light, which may be more than 1. Throws std::runtime_error if a value is not finite.
DAPPLE_API LightPicture picture_of_light(std::span<const float> pixels, int width, int height, int channels);

}  // namespace dapple
