#include "core/lights/sobol.h"

namespace dapple {

namespace {

// Steele, Lea & Flood 2014: every bit of the result depends on every bit of the key.
std::uint64_t mixed(std::uint64_t key) {
    key += 0x9e3779b97f4a7c15;
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9;
    key = (key ^ (key >> 27)) * 0x94d049bb133111eb;
    return key ^ (key >> 31);
}

// Halves change places, then the quarters of each, and so on: each bit is flipped or not by a random number
// of its own for every value of the bits before it.
double owen_scrambled(double coordinate, std::uint64_t seed) {
    const auto bits = static_cast<std::uint32_t>(coordinate * 0x1p32);
    std::uint32_t result = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const std::uint64_t before = (std::uint64_t{1} << 32 | bits) >> bit >> 1;  // led by a 1
        result |= ((bits >> bit ^ static_cast<std::uint32_t>(mixed(seed ^ mixed(before)))) & 1) << bit;
    }
    return result * 0x1p-32;
}

}  // namespace

glm::dvec2 sobol_point(std::uint32_t index) {
    // The direction numbers of the second dimension, of the polynomial x + 1: each is the last one xor its
    // half. Those of the first are single bits.
    std::uint32_t x = 0, y = 0, single = 1u << 31, direction = 1u << 31;
    for (; index > 0; index >>= 1, single >>= 1, direction ^= direction >> 1) {
        if ((index & 1) == 0) continue;
        x ^= single;
        y ^= direction;
    }
    return {x * 0x1p-32, y * 0x1p-32};
}

glm::dvec2 scrambled(glm::dvec2 point, std::uint64_t seed) {
    return {owen_scrambled(point.x, mixed(seed)), owen_scrambled(point.y, ~mixed(seed))};
}

}  // namespace dapple
