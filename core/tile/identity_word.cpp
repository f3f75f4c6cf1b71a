#include "core/tile/identity_word.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/tile/orientation.h"

namespace dapple {

namespace {

__extension__ using Wide = unsigned __int128;

std::uint64_t torus_distance(std::uint64_t a, std::uint64_t b, std::uint64_t period) {
    const std::uint64_t d = a > b ? a - b : b - a;
    return std::min(d, period - d);
}

}  // namespace

TileIntegers integers_of(std::string_view word) {
    assert(!word.empty() && word.size() <= kMaxIdentityWord);
    TileIntegers integers;
    for (const char c : word) {
        const auto letter = static_cast<std::uint64_t>(c - '0');
        integers.a = integers.a << 1 | (letter & 1);
        integers.b = integers.b << 1 | letter >> 1;
    }
    return integers;
}

double relative_radius(std::string_view word) {
    assert(word.size() >= 2 && word.size() <= kMaxIdentityWord);
    const std::size_t count = word.size();
    const std::uint64_t period = (std::uint64_t{1} << count) - 1;
    const auto shift = [&](std::uint64_t v) { return (v << 1 & period) | v >> (count - 1); };

    std::array<TileIntegers, kMaxIdentityWord> points;
    points[0] = integers_of(word);
    Wide smallest = ~Wide{0};
    for (std::size_t i = 1; i < count; ++i) {
        points[i] = {shift(points[i - 1].a), shift(points[i - 1].b)};
        for (std::size_t j = 0; j < i; ++j) {
            const Wide dx = torus_distance(points[i].a, points[j].a, period);
            const Wide dy = torus_distance(points[i].b, points[j].b, period);
            smallest = std::min(smallest, dx * dx + dy * dy);
        }
    }
    const double radius = std::sqrt(static_cast<double>(smallest)) / static_cast<double>(period) / 2;
    return radius / std::sqrt(1 / (2 * std::numbers::sqrt3 * static_cast<double>(count)));
}

std::string smallest_symmetric_word(std::string_view word) {
    std::string smallest;
    for (const Orientation g : all_orientations()) {
        std::string image;
        for (const char c : word) image += static_cast<char>('0' + apply_to_quadrant(g, c - '0'));
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
