#include "core/tile/orientation.h"

namespace dapple {

namespace {

constexpr std::array<SwapAndSigns, 8> kElements{{
    {false, false, false},  // 0
    {true, true, false},    // 90: (-y, x)
    {false, true, true},    // 180
    {true, false, true},    // 270: (y, -x)
    {false, true, false},   // mirror x
    {true, true, true},     // mirror x, then 90: (-y, -x)
    {false, false, true},   // mirror x, then 180: (x, -y)
    {true, false, false},   // mirror x, then 270: (y, x)
}};

}  // namespace

SwapAndSigns steps_of(Orientation g) {
    return kElements[g.index];
}

std::array<Orientation, 8> all_orientations() {
    std::array<Orientation, 8> all;
    for (std::uint8_t i = 0; i < 8; ++i) all[i] = {i};
    return all;
}

Orientation compose(Orientation second, Orientation first) {
    // A rotation that comes before a mirroring turns back after it.
    const bool mirrored = second.index & 4;
    const int turns = mirrored ? second.index - first.index : second.index + first.index;
    return {static_cast<std::uint8_t>(((second.index ^ first.index) & 4) | (turns & 3))};
}

Orientation inverse(Orientation g) {
    // Rotations by 90 and 270 undo each other; everything else is its own inverse.
    return g.index == 1 || g.index == 3 ? Orientation{static_cast<std::uint8_t>(4 - g.index)} : g;
}

int apply_to_quadrant(Orientation g, int q) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    const int x = swap ? q >> 1 : q & 1, y = swap ? q & 1 : q >> 1;
    return (x ^ static_cast<int>(negate_x)) + 2 * (y ^ static_cast<int>(negate_y));
}

glm::dvec2 apply(Orientation g, glm::dvec2 v) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    if (swap) v = {v.y, v.x};
    return {negate_x ? -v.x : v.x, negate_y ? -v.y : v.y};
}

BinaryPoint apply(Orientation g, BinaryPoint p) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    if (swap) p = {p.y, p.x};
    return {negate_x ? ~p.x : p.x, negate_y ? ~p.y : p.y};
}

glm::dvec2 to_unit_square(BinaryPoint p) {
    // The top 53 bits are what a double holds; more would round up to 1 at the far edge.
    return glm::dvec2(static_cast<double>(p.x >> 11), static_cast<double>(p.y >> 11)) * 0x1p-53;
}

int quadrant_of(BinaryPoint p) {
    return static_cast<int>(p.x >> 63) + 2 * static_cast<int>(p.y >> 63);
}

BinaryPoint enlarge_quadrant(BinaryPoint p) {
    return {p.x << 1, p.y << 1};
}

BinaryPoint shrink_to_quadrant(int q, BinaryPoint p) {
    constexpr std::uint64_t top = std::uint64_t{1} << 63;
    return {(p.x >> 1) | (q & 1 ? top : 0), (p.y >> 1) | (q & 2 ? top : 0)};
}

}  // namespace dapple
