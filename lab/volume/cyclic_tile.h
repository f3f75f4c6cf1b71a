#pragma once
// The paper's tiles in any base and dimension (its section 7: "three-way subdivision could be used instead of
// two-way subdivision. Also, point distributions in three or more dimensions could be generated").
//
// A cell of the unit cube is one of b^d letters, by a digit for each axis: letter = x + b y + b^2 z. A cyclic
// word of N letters is a tile of N points,
//
//      point i, axis c:   0.w w' w'' ...  in base b, the digits of axis c of letters i, i + 1, i + 2, ...
//
// so that x -> b x mod 1 leads from each point to the next, and the tile scaled by 1/b onto a cell covers the
// tile's points in that cell. With b = d = 2 it is a tile of one cycle with children that are not turned: see
// core/tile/tile.h, which is what pictures are drawn with. This is apart from it, and small.
//
// Each letter has to be there N / b^d times: then each cell has as many of the tile's points, and a level of
// the subdivision has b^d times as many as the one before. The (b^d - 1) N points that the cells add to their
// parent are its newborns; they appear one after the other, in an order that keeps all that are there even.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/maths/portable_math.h"

namespace dapple {

template <int Base, int Dimension>
struct CyclicTile {
    static constexpr int letters() {
        int all = 1;
        for (int axis = 0; axis < Dimension; ++axis) all *= Base;
        return all;
    }
    static constexpr int digit(int letter, int axis) {
        for (int i = 0; i < axis; ++i) letter /= Base;
        return letter % Base;
    }
    using Point = glm::vec<Dimension, double>;

    std::vector<std::uint8_t> word;
    std::vector<Point> points;  // in the order in which they appear

    /// A point of a cell that its parent does not have.
    struct Newborn {
        int cell = 0;
        std::uint32_t point = 0;  // of the tile
        Point place{};            // in the parent's frame
    };
    std::vector<Newborn> newborns;  // in the order in which they appear

    std::size_t size() const { return points.size(); }
};

/// The word whose letters are written one after the other: 0 to 9, then a to z. Throws std::runtime_error at
/// anything else.
inline std::vector<std::uint8_t> letters_of(std::string_view text) {
    std::vector<std::uint8_t> word;
    for (const char c : text) {
        const bool digit = c >= '0' && c <= '9', small = c >= 'a' && c <= 'z';
        if (!digit && !small) throw std::runtime_error(fmt::format("'{}' is no letter of a word", c));
        word.push_back(static_cast<std::uint8_t>(digit ? c - '0' : c - 'a' + 10));
    }
    return word;
}

template <class Point>
double torus_distance_squared(const Point& a, const Point& b) {
    double sum = 0;
    for (int axis = 0; axis < Point::length(); ++axis) {
        const double apart = std::abs(a[axis] - b[axis]), around = std::min(apart, 1 - apart);
        sum += around * around;
    }
    return sum;
}

/// The points of a word in the order of its letters.
template <int Base, int Dimension>
std::vector<glm::vec<Dimension, double>> points_of_word(std::span<const std::uint8_t> word) {
    using Words = CyclicTile<Base, Dimension>;
    constexpr int kDigits = Base == 2 ? 60 : 40;  // more than a double keeps
    std::vector<glm::vec<Dimension, double>> points(word.size());
    for (std::size_t i = 0; i < word.size(); ++i)
        for (int axis = 0; axis < Dimension; ++axis) {
            double value = 0;
            for (int k = kDigits; k-- > 0;)
                value = (value + Words::digit(word[(i + static_cast<std::size_t>(k)) % word.size()], axis)) /
                        Base;
            points[i][axis] = value;
        }
    return points;
}

/// Half the smallest distance on the torus over the largest that so many points can all have: circles packed
/// in hexagons, spheres as closely as can be.
template <class Point>
double relative_radius(std::span<const Point> points) {
    double least = 1;  // a point's own image
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, torus_distance_squared(points[i], points[j]));
    const auto count = static_cast<double>(points.size());
    const double largest = Point::length() == 2 ? std::sqrt(1 / (2 * std::sqrt(3.0) * count))
                                                : std::cbrt(1 / (4 * std::sqrt(2.0) * count));
    return std::sqrt(least) / 2 / largest;
}

/// An order of new points in which each is where those before it, and those that are there already, have the
/// least energy: that of Gaussians a little narrower than the points are then apart, on the torus.
template <class Point>
std::vector<std::uint32_t> even_order(std::span<const Point> there, std::span<const Point> more) {
    std::vector<std::uint32_t> order, left(more.size());
    std::iota(left.begin(), left.end(), 0u);
    std::vector<Point> all(there.begin(), there.end());
    while (!left.empty()) {
        const double apart = portable::pow(static_cast<double>(all.size() + 1), -1.0 / Point::length());
        const double narrow = 1 / (2 * 0.7 * 0.7 * apart * apart);
        std::size_t best = 0;
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < left.size(); ++i) {
            double energy = 0;
            for (const Point& other : all)
                energy += portable::exp(-torus_distance_squared(more[left[i]], other) * narrow);
            if (energy >= least) continue;
            least = energy;
            best = i;
        }
        order.push_back(left[best]);
        all.push_back(more[left[best]]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return order;
}

/// Throws std::runtime_error if a letter is none of b^d, if they are not all there equally often, or if two
/// points coincide (the word is a repetition of a shorter one).
template <int Base, int Dimension>
CyclicTile<Base, Dimension> make_cyclic_tile(std::vector<std::uint8_t> word) {
    using Words = CyclicTile<Base, Dimension>;
    using Point = typename Words::Point;
    std::vector<std::size_t> times(Words::letters());
    for (const std::uint8_t letter : word) {
        if (letter >= Words::letters())
            throw std::runtime_error(
                fmt::format("letter {} of a word: there are only {}", letter, Words::letters()));
        ++times[letter];
    }
    if (word.empty() || times != std::vector(times.size(), word.size() / times.size()))
        throw std::runtime_error(
            fmt::format("a word has to have each of {} letters equally often", Words::letters()));
    const std::vector<Point> points = points_of_word<Base, Dimension>(word);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (torus_distance_squared(points[i], points[j]) < 1e-20)
                throw std::runtime_error("a word may not be a repetition of a shorter one");

    Words tile{.word = std::move(word), .points = {}, .newborns = {}};
    std::vector<std::uint32_t> place(points.size());  // in the order, by letter
    for (const std::uint32_t i : even_order<Point>({}, points)) {
        place[i] = static_cast<std::uint32_t>(tile.points.size());
        tile.points.push_back(points[i]);
    }
    // Point i of a cell is the parent's if the letter before it is that cell's.
    std::vector<typename Words::Newborn> newborns;
    std::vector<Point> places;
    for (int cell = 0; cell < Words::letters(); ++cell)
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (tile.word[(i + points.size() - 1) % points.size()] == cell) continue;
            Point corner;
            for (int axis = 0; axis < Dimension; ++axis) corner[axis] = Words::digit(cell, axis);
            places.push_back((corner + points[i]) / double{Base});
            newborns.push_back({cell, place[i], places.back()});
        }
    for (const std::uint32_t i : even_order<Point>(tile.points, places)) tile.newborns.push_back(newborns[i]);
    return tile;
}

/// A cell of the subdivision: its side is b^-level, its corner a multiple of that.
template <int Dimension>
struct SubdivisionCell {
    int level = 0;
    glm::vec<Dimension, std::int64_t> place{0};
};

/// A dot of the subdivision, and the scale from which on it is there.
template <int Dimension>
struct CriticalDot {
    glm::vec<Dimension, double> place;  // in [0, 1)
    double critical;
};

/// All dots on the unit cube that are there at a scale, in the order of the subdivision: a dot that appears
/// as the n-th of an even density of 1 has the critical scale n - 1/2 over the density at its place. So there
/// are about scale times the density's integral. `most(cell)` is at least the density at any place of the
/// cell, `at(place)` the density at one; both finite and not below 0.
template <int Base, int Dimension, class Most, class At>
std::vector<CriticalDot<Dimension>> subdivided(const CyclicTile<Base, Dimension>& tile, double scale,
                                               const Most& most, const At& at) {
    using Words = CyclicTile<Base, Dimension>;
    std::vector<CriticalDot<Dimension>> dots;
    const auto count = static_cast<double>(tile.size());
    const auto test = [&](const glm::vec<Dimension, double>& place, double threshold) {
        const double density = at(place);
        if (density * scale > threshold) dots.push_back({place, threshold / density});
    };
    for (std::size_t rank = 0; rank < tile.size(); ++rank)
        test(tile.points[rank], static_cast<double>(rank) + 0.5);
    // Equal ranks of a level's cells follow each other so that neighbours are far apart: `turn`, 0..1.
    const auto visit = [&](const auto& self, const SubdivisionCell<Dimension>& cell, double turn) -> void {
        const double cells = std::pow(static_cast<double>(Words::letters()), cell.level);
        if (most(cell) * scale <= cells * count) return;
        const double side = std::pow(static_cast<double>(Base), -cell.level);
        const auto corner = glm::vec<Dimension, double>(cell.place) * side;
        for (std::size_t rank = 0; rank < tile.newborns.size(); ++rank)
            test(corner + tile.newborns[rank].place * side,
                 cells * (count + static_cast<double>(rank) + turn));
        for (int letter = 0; letter < Words::letters(); ++letter) {
            SubdivisionCell<Dimension> child{cell.level + 1, cell.place * std::int64_t{Base}};
            for (int axis = 0; axis < Dimension; ++axis) child.place[axis] += Words::digit(letter, axis);
            self(self, child, (letter + turn) / Words::letters());
        }
    };
    visit(visit, {}, 0.5);
    return dots;
}

}  // namespace dapple
