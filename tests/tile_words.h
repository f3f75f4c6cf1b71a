#pragma once
// The way back from a tile's points to its words.

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {

/// Binary points are rounded down, so a point found by going down one digit may differ in the last ones.
inline std::pair<std::uint64_t, std::uint64_t> key_of(BinaryPoint p) {
    constexpr int kComparedBits = 40;
    return {p.x >> (64 - kComparedBits), p.y >> (64 - kComparedBits)};
}

/// The words of a set of points that is self-similar under a rule, the same words whatever the points' order:
/// see words_along(). Throws std::runtime_error if the set is not self-similar.
inline std::vector<std::string> words_of(const std::vector<BinaryPoint>& points, const Rule& rule) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint32_t> index;
    for (const BinaryPoint p : points) index[key_of(p)] = 0;
    std::uint32_t count = 0;
    for (auto& entry : index) entry.second = count++;

    std::string letters(count, '0');
    std::vector<std::uint32_t> successor(count);
    for (const BinaryPoint p : points) {
        const std::uint32_t i = index[key_of(p)];
        const int q = quadrant_of(p);
        letters[i] = static_cast<char>('0' + q);
        const auto found = index.find(key_of(apply(inverse(rule.child[q]), enlarge_quadrant(p))));
        if (found == index.end()) throw std::runtime_error("the points are not self-similar under the rule");
        successor[i] = found->second;
    }
    return words_along(letters, successor);
}

}  // namespace dapple
