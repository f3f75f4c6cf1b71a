#pragma once
// Tiles and densities that placers are tested on.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/image/grid.h"
#include "core/tile/tile.h"

namespace dapple {

/// Four orientations, no two alike.
inline const Rule kTurning{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};

/// A tile of one random cycle.
inline Tile random_tile(const Rule& rule, int points, unsigned seed) {
    std::mt19937 random(seed);
    while (true) {
        std::string word;
        for (int i = 0; i < points; ++i) word += static_cast<char>('0' + i % 4);
        std::shuffle(word.begin(), word.end(), random);
        try {
            return make_tile(rule, {word});
        } catch (const std::runtime_error&) {  // the word repeats itself: another one
        }
    }
}

/// A tile of several kinds: each takes any quarter of the points of each of its children's.
inline Tile random_kinds(const Rule& rule, const NextKinds& next, std::uint32_t points, unsigned seed) {
    std::string letters;
    std::vector<std::uint32_t> successor, chosen(points);
    std::mt19937 random(seed);
    for (const auto& children : next) {
        for (std::size_t q = 0; q < 4; ++q) {
            std::iota(chosen.begin(), chosen.end(), children[q] * points);
            std::shuffle(chosen.begin(), chosen.end(), random);
            letters.append(points / 4, static_cast<char>('0' + q));
            successor.insert(successor.end(), chosen.begin(), chosen.begin() + points / 4);
        }
    }
    try {
        return make_tile(rule, next, letters, successor);
    } catch (const std::runtime_error&) {  // two points coincide: others
        return random_kinds(rule, next, points, seed + 1000);
    }
}

/// Three kinds of which every two touch, and none makes only itself.
inline const NextKinds kThreeKinds{{0, 1, 2, 1}, {2, 0, 0, 2}, {1, 2, 1, 0}};

/// Scattered dark pixels on white.
inline Grid<float> blotches(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Grid<float> grid(width, height);
    for (float& v : grid.values) v = random() % 3 == 0 ? static_cast<float>(random() % 1000) / 999.0f : 0.0f;
    grid.at(0, 0) = 0.8f;
    return grid;
}

}  // namespace dapple
