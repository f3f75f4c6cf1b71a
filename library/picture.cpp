#include "dapple/picture.h"

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>

#include "core/image/linear_colour.h"

namespace dapple {
namespace {

constexpr glm::vec3 kRec709{0.2126f, 0.7152f, 0.0722f};

std::array<float, 256> light_of_bytes() {
    std::array<float, 256> light;
    for (int i = 0; i < 256; ++i)
        light[static_cast<std::size_t>(i)] = srgb_to_linear(static_cast<float>(i) / 255.0f);
    return light;
}

}  // namespace

LightPicture picture_of_srgb(std::span<const std::uint8_t> pixels, int width, int height, int channels) {
    if (width < 1 || height < 1 || channels < 1 || channels > 4)
        throw std::runtime_error(
            fmt::format("a picture of {} x {} pixels with {} channels; sides are 1 or more, and channels 1 "
                        "to 4",
                        width, height, channels));
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto each = static_cast<std::size_t>(channels);
    if (pixels.size() != count * each)
        throw std::runtime_error(
            fmt::format("{} bytes for a picture of {} x {} pixels with {} channels, which has {}",
                        pixels.size(), width, height, channels, count * each));
    static const std::array<float, 256> light = light_of_bytes();
    const bool coloured = channels > 2, transparent = channels % 2 == 0;
    LightPicture picture{width, height, std::vector<float>(count), {}};
    if (coloured) picture.colours.resize(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* const pixel = &pixels[i * each];
        glm::vec3 colour = coloured ? glm::vec3(light[pixel[0]], light[pixel[1]], light[pixel[2]])
                                    : glm::vec3(light[pixel[0]]);
        if (transparent)
            colour = glm::mix(glm::vec3(1), colour, static_cast<float>(pixel[each - 1]) / 255.0f);
        picture.light[i] = glm::dot(colour, kRec709);
        for (int k = 0; coloured && k < 3; ++k)
            picture.colours[3 * i + static_cast<std::size_t>(k)] = colour[k];
    }
    return picture;
}

}  // namespace dapple
