#pragma once
// Tiles and densities that placers are tested on.

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>

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

/// Scattered dark pixels on white.
inline Grid<float> blotches(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Grid<float> grid(width, height);
    for (float& v : grid.values) v = random() % 3 == 0 ? static_cast<float>(random() % 1000) / 999.0f : 0.0f;
    grid.at(0, 0) = 0.8f;
    return grid;
}

}  // namespace dapple
