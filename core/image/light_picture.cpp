#include "core/image/light_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/failure.h"

namespace dapple {
namespace {

/// `light_of` a value of a pixel; alpha is full at `full`.
template <class Value, class LightOf>
LightPicture picture_of(std::span<const Value> pixels, int width, int height, int channels, float full,
                        const LightOf& light_of) {
    if (width < 1 || height < 1 || channels < 1 || channels > 4)
        throw failure(
            "a picture of {} x {} pixels with {} channels; sides are 1 or more, and channels 1 to 4", width,
            height, channels);
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto each = static_cast<std::size_t>(channels);
    if (pixels.size() != count * each)
        throw failure("{} values for a picture of {} x {} pixels with {} channels, which has {}",
                      pixels.size(), width, height, channels, count * each);
    const bool coloured = channels > 2, transparent = channels % 2 == 0;
    LightPicture picture{.light = {width, height}};
    if (coloured) picture.colours = {width, height};
    for (std::size_t i = 0; i < count; ++i) {
        const Value* const pixel = &pixels[i * each];
        glm::vec3 colour = coloured ? glm::vec3(light_of(pixel[0]), light_of(pixel[1]), light_of(pixel[2]))
                                    : glm::vec3(light_of(pixel[0]));
        if (transparent) colour = glm::mix(glm::vec3(1), colour, static_cast<float>(pixel[each - 1]) / full);
        picture.light.values[i] = luminance(colour);
        if (coloured) picture.colours.values[i] = packed(colour);
    }
    return picture;
}

template <class Value>
LightPicture picture_of_whole_numbers(std::span<const Value> pixels, int width, int height, int channels) {
    static constexpr std::size_t kWhole = std::numeric_limits<Value>::max();
    static const std::vector<float> light = [] {
        std::vector<float> of_value(kWhole + 1);
        for (std::size_t i = 0; i <= kWhole; ++i)
            of_value[i] = srgb_to_linear(static_cast<float>(i) / static_cast<float>(kWhole));
        return of_value;
    }();
    return picture_of(pixels, width, height, channels, static_cast<float>(kWhole),
                      [&](Value value) { return light[value]; });
}

}  // namespace

LightPicture picture_of_srgb(std::span<const std::uint8_t> pixels, int width, int height, int channels) {
    return picture_of_whole_numbers(pixels, width, height, channels);
}

LightPicture picture_of_srgb(std::span<const std::uint16_t> pixels, int width, int height, int channels) {
    return picture_of_whole_numbers(pixels, width, height, channels);
}

LightPicture picture_of_srgb(std::span<const float> pixels, int width, int height, int channels) {
    const auto wrong = std::ranges::find_if(pixels, [](float value) { return !(value >= 0 && value <= 1); });
    if (wrong != pixels.end())
        throw failure(
            "a picture has the value {}; sRGB-encoded numbers are within 0 to 1, and linear light alone may "
            "be more",
            *wrong);
    return picture_of(pixels, width, height, channels, 1, srgb_to_linear);
}

LightPicture picture_of_light(std::span<const float> pixels, int width, int height, int channels) {
    if (!std::ranges::all_of(pixels, [](float value) { return std::isfinite(value); }))
        throw std::runtime_error("a picture's light has a value that is not finite");
    return picture_of(pixels, width, height, channels, 1, [](float value) { return value; });
}

}  // namespace dapple
