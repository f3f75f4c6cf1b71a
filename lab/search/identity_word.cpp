#include "lab/search/identity_word.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <compare>
#include <numbers>

#include "core/tile/tile.h"

namespace dapple {

namespace {

// Whole numbers below 2^120.
#if defined(__SIZEOF_INT128__)
__extension__ using Wide = unsigned __int128;
constexpr Wide kMostWide = ~Wide{0};

Wide sum_of_squares(std::uint64_t x, std::uint64_t y) {
    return Wide{x} * x + Wide{y} * y;
}
#else
struct Wide {
    std::uint64_t high = 0, low = 0;  // high * 2^60 + low
    auto operator<=>(const Wide&) const = default;
    explicit operator double() const { return static_cast<double>(high) * 0x1p60 + static_cast<double>(low); }
};
constexpr Wide kMostWide{~std::uint64_t{0}, 0};

Wide sum_of_squares(std::uint64_t x, std::uint64_t y) {
    constexpr std::uint64_t kHalf = (1u << 30) - 1;
    const std::uint64_t x1 = x >> 30, x0 = x & kHalf, y1 = y >> 30, y0 = y & kHalf;
    const std::uint64_t low = x0 * x0 + y0 * y0;
    const std::uint64_t middle = 2 * (x1 * x0 + y1 * y0) + (low >> 30);
    return {x1 * x1 + y1 * y1 + (middle >> 30), (middle & kHalf) << 30 | (low & kHalf)};
}
#endif

std::uint64_t torus_distance(std::uint64_t a, std::uint64_t b, std::uint64_t period) {
    const std::uint64_t d = a > b ? a - b : b - a;
    return std::min(d, period - d);
}

}  // namespace

double relative_radius(std::string_view word) {
    assert(word.size() >= 2 && word.size() <= kMaxIdentityWord);
    const std::size_t count = word.size();
    const std::uint64_t period = (std::uint64_t{1} << count) - 1;
    const auto shift = [&](std::uint64_t v) { return (v << 1 & period) | v >> (count - 1); };

    std::array<TileIntegers, kMaxIdentityWord> points;
    points[0] = integers_of(word);
    Wide smallest = kMostWide;
    for (std::size_t i = 1; i < count; ++i) {
        points[i] = {shift(points[i - 1].a), shift(points[i - 1].b)};
        for (std::size_t j = 0; j < i; ++j) {
            const std::uint64_t dx = torus_distance(points[i].a, points[j].a, period);
            const std::uint64_t dy = torus_distance(points[i].b, points[j].b, period);
            smallest = std::min(smallest, sum_of_squares(dx, dy));
        }
    }
    const double radius = std::sqrt(static_cast<double>(smallest)) / static_cast<double>(period) / 2;
    return radius / std::sqrt(1 / (2 * std::numbers::sqrt3 * static_cast<double>(count)));
}

std::array<std::string, 8> symmetric_words(std::string_view word) {
    std::array<std::string, 8> words;
    for (const Orientation g : all_orientations())
        for (const char c : word) words[g.index] += static_cast<char>('0' + apply_to_quadrant(g, c - '0'));
    return words;
}

std::string smallest_symmetric_word(std::string_view word) {
    std::string smallest;
    for (std::string& image : symmetric_words(word)) {
        for (std::size_t i = 0; i < image.size(); ++i) {
            std::rotate(image.begin(), image.begin() + 1, image.end());
            if (smallest.empty() || image < smallest) smallest = image;
        }
    }
    return smallest;
}

double balanced_share(int length) {
    if (length % 2 != 0) return 0;
    double share = 1;
    for (int i = 1; i <= length / 2; ++i) share *= (length / 2 + i) / (4.0 * i);
    return share;
}

}  // namespace dapple
