#pragma once
// PNG into a stream, with the size on paper in it.

#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

enum class PngColours { rgb, grey };

/// What the settings that a drawing was made with are called in it.
inline constexpr const char* kPngSettingsKeyword = "dapple";

struct PngText {
    const char* keyword = "";
    std::string text = {};  // Latin-1
};

struct PngHeader {
    int width = 0, height = 0;
    double dpi = 300;
    PngColours colours =
        PngColours::rgb;  // grey takes red, green and blue to be equal, and is a third of the work
    std::vector<PngText> texts = {};  // empty ones are left out
};

/// A stretch of rows, from the top down.
using PixelSink = std::function<void(const Grid<glm::u8vec3>& band)>;

/// Calls `draw` with a sink, to which it gives all rows in order. Throws std::runtime_error if the picture is
/// too large for PNG; what `draw` or the stream throw passes through.
void write_png(std::ostream& out, const PngHeader& header, const std::function<void(const PixelSink&)>& draw);

using PixelSink16 = std::function<void(const Grid<glm::u16vec3>& band)>;

/// The same with 16 bits a channel.
void write_png_16(std::ostream& out, const PngHeader& header,
                  const std::function<void(const PixelSink16&)>& draw);

}  // namespace dapple
