#include "core/placing/tie_order.h"

#include <algorithm>
#include <bit>

namespace dapple {

namespace {

constexpr int kMostDigits = 16;

// How often the page's square is halved until a square holds one dot of a threshold, or none: tiles of that
// level are 4^digits or fewer.
int digits_for(float threshold) {
    const int log2 = std::bit_width(static_cast<std::uint32_t>(std::clamp(threshold, 1.0f, 0x1p31f)));
    return std::min((log2 + 1) / 2, kMostDigits);
}

// The lowest `digits` of 16 bits, the last one in front.
std::uint32_t reversed(std::uint32_t v, int digits) {
    v = (v & 0x5555) << 1 | (v >> 1 & 0x5555);
    v = (v & 0x3333) << 2 | (v >> 2 & 0x3333);
    v = (v & 0x0f0f) << 4 | (v >> 4 & 0x0f0f);
    v = (v & 0x00ff) << 8 | (v >> 8 & 0x00ff);
    return v >> (16 - digits);
}

// A zero in front of each of 16 bits.
std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 8) & 0x00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
}

// The digits of a square's address, the last one in front, each as in Bayer's matrix of 2 x 2.
std::uint32_t dither_of(std::uint32_t column, std::uint32_t row, int digits) {
    return spread(reversed(column ^ row, digits)) << 1 | spread(reversed(row, digits));
}

}  // namespace

TieKey tie_key(float x, float y, float threshold) {
    const int digits = digits_for(threshold);
    const auto cell = [digits](float position) {
        const auto cells = static_cast<float>(1u << digits);
        return static_cast<std::uint32_t>(std::clamp(position * cells, 0.0f, cells - 1));
    };
    return {dither_of(cell(x), cell(y), digits),
            std::uint64_t{std::bit_cast<std::uint32_t>(y)} << 32 | std::bit_cast<std::uint32_t>(x)};
}

}  // namespace dapple
