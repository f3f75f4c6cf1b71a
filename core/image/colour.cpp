#include "core/image/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/failure.h"

namespace dapple {

glm::vec3 parse_colour(std::string_view text) {
    std::string_view digits = text;
    if (digits.starts_with('#')) digits.remove_prefix(1);
    unsigned value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool whole = error == std::errc{} && end == digits.data() + digits.size();
    if (!whole || (digits.size() != 6 && digits.size() != 3)) {
        throw failure("{}: not a colour; write it as #rrggbb, for example #1a2b3c", text);
    }
    const int bits = digits.size() == 6 ? 8 : 4;
    const unsigned top = (1u << bits) - 1;
    const auto component = [&](int place) {
        return static_cast<float>(value >> (place * bits) & top) / static_cast<float>(top);
    };
    return {component(2), component(1), component(0)};
}

std::string hex_of(glm::vec3 colour) {
    const auto byte = [](float v) { return std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.x), byte(colour.y), byte(colour.z));
}

std::string pen_name(glm::vec3 colour) {
    const std::string hex = hex_of(colour);
    if (hex == "#000000") return "Black";
    if (hex == "#ffffff") return "White";
    return hex;
}

glm::vec3 level_colour(int level) {
    // Six hues far apart, in an order in which neighbours differ in lightness too.
    static constexpr std::array<glm::vec3, 6> hues{{{0.84f, 0.15f, 0.16f},
                                                    {0.12f, 0.47f, 0.71f},
                                                    {0.93f, 0.58f, 0.06f},
                                                    {0.17f, 0.58f, 0.25f},
                                                    {0.89f, 0.42f, 0.69f},
                                                    {0.42f, 0.24f, 0.60f}}};
    return hues[static_cast<std::size_t>(std::max(level, 0)) % hues.size()];
}

}  // namespace dapple
