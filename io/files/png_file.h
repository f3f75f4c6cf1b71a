#pragma once
// PNG into a stream, with the size on paper in it.

#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <ostream>
#include <string>
#include <type_traits>
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

/// Takes a stretch of rows, from the top down. A channel is a number of 8 bits or of 16.
template <class Channel>
using SinkOf = std::function<void(const Grid<glm::vec<3, Channel>>& band)>;
using PixelSink = SinkOf<std::uint8_t>;

/// Gives such a sink all rows in order.
template <class Channel>
using DrawInto = std::function<void(const SinkOf<Channel>&)>;

/// Calls `draw` with a sink. Throws std::runtime_error if the picture is too large for PNG; what `draw` or
/// the stream throw passes through.
template <class Channel = std::uint8_t>
void write_png(std::ostream& out, const PngHeader& header,
               const std::type_identity_t<DrawInto<Channel>>& draw);

}  // namespace dapple
