#include "core/placing/tie_order.h"

#include <algorithm>
#include <cmath>

namespace dapple {

namespace {

constexpr int kMostDigits = 16;

// How often the page's square is halved until a square holds one dot of a threshold, or none: tiles of that
// level are 4^digits or fewer.
int digits_for(float threshold) {
    const int log2 = std::ilogb(std::max(threshold, 1.0f)) + 1;
    return std::min((log2 + 1) / 2, kMostDigits);
}

// The digits of a square's address, the last one in front, each as in Bayer's matrix of 2 x 2.
std::uint32_t dither_of(std::uint32_t column, std::uint32_t row, int digits) {
    std::uint32_t index = 0;
    for (int digit = 0; digit < digits; ++digit) {
        const std::uint32_t right = column >> digit & 1, lower = row >> digit & 1;
        index = index << 2 | ((right ^ lower) << 1 | lower);
    }
    return index;
}

}  // namespace

TieKey tie_key(const Dots& dots, std::size_t index) {
    const float x = dots.x[index], y = dots.y[index];
    const int digits = digits_for(dots.threshold[index]);
    const auto cell = [digits](float position) {
        const float cells = std::ldexp(1.0f, digits);
        return static_cast<std::uint32_t>(std::clamp(position * cells, 0.0f, cells - 1));
    };
    return {dither_of(cell(x), cell(y), digits), y, x};
}

}  // namespace dapple
