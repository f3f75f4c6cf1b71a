#pragma once
// Words of cyclic tiles (lab/volume/cyclic_tile.h) in any base and dimension: all of them, where there are
// few, or the best that annealing finds.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/tile/random.h"
#include "lab/volume/cyclic_tile.h"

namespace dapple {

/// Each letter equally often, in ascending order. `count` has to be a multiple of b^d.
template <int Base, int Dimension>
std::vector<std::uint8_t> first_word(int count) {
    using Words = CyclicTile<Base, Dimension>;
    std::vector<std::uint8_t> word;
    for (int i = 0; i < count; ++i) word.push_back(static_cast<std::uint8_t>(i / (count / Words::letters())));
    return word;
}

struct AllWords {
    std::uint64_t words = 0;                                           // that begin with a 0
    std::map<double, std::vector<std::uint8_t>, std::greater<>> best;  // by radius; one word of each
};

/// Every word of so many letters that begins with a 0, with the best relative radii, each value once (to six
/// digits). Rotations and symmetries are not taken out.
template <int Base, int Dimension>
AllWords all_words(int count, std::size_t how_many = 5) {
    AllWords found;
    std::vector<std::uint8_t> word = first_word<Base, Dimension>(count);
    do {
        ++found.words;
        const auto points = points_of_word<Base, Dimension>(word);
        const double radius = std::round(relative_radius<glm::vec<Dimension, double>>(points) * 1e6) / 1e6;
        if (found.best.size() == how_many && radius <= std::prev(found.best.end())->first) continue;
        found.best.emplace(radius, word);
        if (found.best.size() > how_many) found.best.erase(std::prev(found.best.end()));
    } while (std::next_permutation(word.begin() + 1, word.end()));
    return found;
}

/// The same by branch and bound, in passes with lower and lower floors, for words that are too many to look
/// at: a word is built from its end, as lab/search/word_tree.h does it for pictures' tiles. Putting a letter
/// in front adds a point that lies in a box of side b^-(letters), and the word is dropped when that box and
/// an older one are certain to hold points that are too close. At most `how_many` radii, best first; all
/// above `lowest` are there, if there are not more.
template <int Base, int Dimension>
AllWords best_words(int count, std::size_t how_many, double lowest) {
    using Words = CyclicTile<Base, Dimension>;
    using Point = typename Words::Point;
    const double packed = Dimension == 2 ? std::sqrt(1 / (2 * std::sqrt(3.0) * count))
                                         : std::cbrt(1 / (4 * std::sqrt(2.0) * count));
    AllWords found;
    for (double floor = 0.97; found.best.size() < how_many && floor > lowest - 0.03; floor -= 0.03) {
        const double bound = std::max(floor, lowest);
        const double least = std::pow(2 * packed * bound, 2) * (1 - 1e-9);
        found = {};
        std::vector<std::uint8_t> word(static_cast<std::size_t>(count));
        std::vector<int> left(static_cast<std::size_t>(Words::letters()), count / Words::letters());
        std::vector<Point> low(word.size());
        std::vector<double> side(word.size());
        // Points word.size() - 1, word.size() - 2, ... down to `first` are there.
        const auto extend = [&](const auto& self, std::size_t first) -> void {
            if (first == 0) {
                ++found.words;
                const auto points = points_of_word<Base, Dimension>(word);
                const double radius = std::round(relative_radius<Point>(points) * 1e6) / 1e6;
                if (radius < bound) return;
                found.best.emplace(radius, word);
                if (found.best.size() > how_many) found.best.erase(std::prev(found.best.end()));
                return;
            }
            const std::size_t at = first - 1;
            for (int letter = 0; letter < Words::letters(); ++letter) {
                // All rotations are the same tile: this one ends in a 0.
                if (left[letter] == 0 || (first == word.size() && letter != 0)) continue;
                Point corner;
                for (int axis = 0; axis < Dimension; ++axis)
                    corner[axis] =
                        (Words::digit(letter, axis) + (first < word.size() ? low[first][axis] : 0)) / Base;
                low[at] = corner;
                side[at] = (first < word.size() ? side[first] : 1.0) / Base;
                bool too_close = false;
                for (std::size_t other = first; other < word.size() && !too_close; ++other) {
                    double furthest = 0;
                    for (int axis = 0; axis < Dimension; ++axis) {
                        // The greatest distance on the circle between the two stretches.
                        const double from = corner[axis] - low[other][axis] - side[other],
                                     to = corner[axis] + side[at] - low[other][axis];
                        const auto around = [](double x) {
                            const double apart = std::abs(x - std::floor(x + 0.5));
                            return apart;
                        };
                        const bool half = std::floor(from - 0.5) != std::floor(to - 0.5);
                        const double most = half ? 0.5 : std::max(around(from), around(to));
                        furthest += most * most;
                    }
                    too_close = furthest < least;
                }
                if (too_close) continue;
                word[at] = static_cast<std::uint8_t>(letter);
                --left[letter];
                self(self, at);
                ++left[letter];
            }
        };
        extend(extend, word.size());
    }
    return found;
}

/// What a word is annealed for.
enum class WordAim {
    radius,  // the smallest distance on the torus
    energy,  // of Gaussians half as wide as points are apart: even, but no lattice
};

/// The best word that so many exchanges of two letters lead to. The same for the same seed.
template <int Base, int Dimension>
std::vector<std::uint8_t> annealed_word(int count, WordAim aim, std::uint64_t seed, int steps) {
    using Point = glm::vec<Dimension, double>;
    const double apart = std::pow(static_cast<double>(count), -1.0 / Dimension);
    // A radius is little to go by: all distances count, the smallest by far most.
    const auto cost = [&](const std::vector<std::uint8_t>& word) {
        const std::vector<Point> points = points_of_word<Base, Dimension>(word);
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double far = torus_distance_squared(points[i], points[j]) / (apart * apart);
                sum += aim == WordAim::radius ? std::pow(far + 1e-6, -10.0) : std::exp(-2 * far);
            }
        return aim == WordAim::radius ? std::log(sum) : sum;
    };
    Random random(seed);
    std::vector<std::uint8_t> word = first_word<Base, Dimension>(count);
    for (std::size_t i = 1; i < word.size(); ++i) std::swap(word[i], word[random.below(i + 1)]);
    std::vector<std::uint8_t> best = word;
    double now = cost(word), least = now;
    for (int step = 0; step < steps; ++step) {
        const double heat = (aim == WordAim::radius ? 1.0 : 0.5) * std::pow(1e-3, step / double(steps));
        const std::size_t a = random.below(word.size()), b = random.below(word.size());
        if (word[a] == word[b]) continue;
        std::swap(word[a], word[b]);
        const double then = cost(word);
        if (then <= now || random.unit() < std::exp((now - then) / heat)) {
            now = then;
            if (now < least) {
                least = now;
                best = word;
            }
        } else {
            std::swap(word[a], word[b]);
        }
    }
    return best;
}

}  // namespace dapple
