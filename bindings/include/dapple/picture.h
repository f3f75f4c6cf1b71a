#pragma once
// A picture in memory, as light.

#include <cstdint>
#include <span>
#include <vector>

#include "dapple/export.h"

namespace dapple {

/// Linear light with the primaries of sRGB, row after row from the top: 0 is black, 1 as light as paper.
/// Pictures of the outdoors may have more.
struct LightPicture {
    int width = 0, height = 0;   // pixels, 1 or more
    std::vector<float> light;    // width * height: luminance
    std::vector<float> colours;  // 3 * width * height: red, green, blue, for several pens; empty: a grey one
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

/// The same of linear light, which may be more than 1.
DAPPLE_API LightPicture picture_of_light(std::span<const float> pixels, int width, int height, int channels);

}  // namespace dapple
