#pragma once
// A picture as light, whatever file it came in.

#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <string_view>

#include "core/image/grid.h"

namespace dapple {

/// The preview's longer side is at most this, in pixels.
inline constexpr int kPreviewSide = 2048;

struct Picture {
    Grid<float> light;  // linear luminance over white paper: 0 black, 1 paper, more in HDR pictures
    /// sRGB-encoded colours over white paper, opaque, same aspect as light; exposed by the stops below.
    Grid<glm::u8vec4> preview;
    /// usual_exposure() of the light if the file has it as it was in front of a camera, else 0.
    float exposure = 0;
    std::string description;  // "512 x 512 pixels, 8-bit grey png"
};

enum class PictureLimit {
    usual,  // up to 400 megapixels
    huge,   // whatever fits in memory
};

/// Reads the first picture of a file in any of picture_formats(), the right way up.
///
/// Integer pixels are taken as sRGB-encoded and float ones as linear light unless the file says otherwise.
/// Luminance has Rec. 709 weights. Transparent parts show white paper. Memory: 4 bytes a pixel.
/// Formats are told by content; libraries read them in a process of their own, with limits on memory and
/// time.
///
/// Throws std::runtime_error with one sentence if the file is missing, a folder, empty, not a picture,
/// damaged, too large, or has pixels that are NaN or infinite.
Picture read_picture(const std::filesystem::path& path, PictureLimit limit = PictureLimit::usual);

/// A PNG in memory, such as the built-in sample. Throws std::runtime_error if it is none.
Picture decode_png(std::string_view bytes);

}  // namespace dapple
