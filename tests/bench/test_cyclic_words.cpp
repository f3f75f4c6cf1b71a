// Cyclic tiles in several bases and dimensions, against numbers that an independent program found, against
// the tiles that pictures are drawn with, and against what self-similar means.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/tile/tile.h"
#include "lab/volume/cyclic_tile.h"
#include "tests/bench/cyclic_words.h"

namespace dapple {
namespace {

template <class Point>
std::tuple<long, long, long> rounded(const Point& point) {
    const auto at = [&](int axis) { return axis < Point::length() ? std::lround(point[axis] * 1e9) : 0L; };
    return {at(0), at(1), at(2)};
}

template <int Base, int Dimension>
void check_radii(int count, std::uint64_t words, const std::vector<double>& radii) {
    CAPTURE(Base);
    CAPTURE(Dimension);
    CAPTURE(count);
    const AllWords found = all_words<Base, Dimension>(count, radii.size());
    CHECK(found.words == words);
    REQUIRE(found.best.size() == radii.size());
    auto radius = radii.begin();
    for (const auto& [best, word] : found.best) CHECK(best == doctest::Approx(*radius++).epsilon(1e-9));
}

template <int Base, int Dimension>
void check_self_similar(const std::string& word) {
    using Words = CyclicTile<Base, Dimension>;
    const Words tile = make_cyclic_tile<Base, Dimension>(letters_of(word));
    REQUIRE(tile.size() == word.size());
    REQUIRE(tile.newborns.size() == word.size() * (Words::letters() - 1));
    // The points of all cells are the tile's own and its newborns, each once.
    std::set<std::tuple<long, long, long>> cells, own, newborn;
    for (int cell = 0; cell < Words::letters(); ++cell)
        for (const auto& point : tile.points) {
            typename Words::Point corner;
            for (int axis = 0; axis < Dimension; ++axis) corner[axis] = Words::digit(cell, axis);
            cells.insert(rounded((corner + point) / double{Base}));
        }
    for (const auto& point : tile.points) own.insert(rounded(point));
    for (const auto& each : tile.newborns) newborn.insert(rounded(each.place));
    CHECK(cells.size() == word.size() * Words::letters());
    CHECK(std::ranges::includes(cells, own));
    CHECK(std::ranges::includes(cells, newborn));
    for (const auto& each : newborn) CHECK_FALSE(own.contains(each));

    // At a full level the subdivision is the tile in each of its cells; before that a part of it.
    const auto even = [](const auto&) { return 1.0; };
    const double full = static_cast<double>(word.size()) * Words::letters();
    std::set<std::tuple<long, long, long>> drawn, half;
    for (const auto& dot : subdivided(tile, full, even, even)) drawn.insert(rounded(dot.place));
    CHECK(drawn == cells);
    const auto half_dots = subdivided(tile, full / 2, even, even);
    CHECK(std::abs(static_cast<double>(half_dots.size()) - full / 2) <= 1);
    for (const auto& dot : half_dots) half.insert(rounded(dot.place));
    CHECK(std::ranges::includes(drawn, half));
}

}  // namespace

TEST_CASE("the best relative radii of all words are those that an independent program found") {
    check_radii<2, 2>(4, 6, {0.832358, 0.372242});
    check_radii<2, 2>(8, 630, {0.638390, 0.558637, 0.558256, 0.553271});
    check_radii<3, 2>(9, 40'320, {0.700108, 0.695484, 0.690465, 0.683760, 0.669711});
    check_radii<2, 3>(8, 5'040, {0.628598, 0.623607, 0.620074, 0.611151, 0.590676});
}

TEST_CASE("with two digits on two axes a tile is the paper's") {
    const std::string word = "0301223132110203";
    const Tile tile = make_tile(Rule{}, {word});
    const auto points = points_of_word<2, 2>(letters_of(word));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 place{std::ldexp(static_cast<double>(tile.points[i].x), -64),
                               std::ldexp(static_cast<double>(tile.points[i].y), -64)};
        CHECK(place.x == doctest::Approx(points[i].x).epsilon(1e-12));
        CHECK(place.y == doctest::Approx(points[i].y).epsilon(1e-12));
    }
}

TEST_CASE("scaled onto a cell, a tile covers its own points there, in each base and dimension") {
    check_self_similar<2, 2>("0312");
    check_self_similar<3, 2>("026174358");
    check_self_similar<3, 2>("348006758532127461");
    check_self_similar<2, 3>("60452731");
    check_self_similar<2, 3>("1723304641075526");
}

TEST_CASE("a density gets its share of the dots, and none where it is 0") {
    const auto tile = make_cyclic_tile<3, 2>(letters_of("026174358"));
    // A third of the square, once as dense and once half as dense.
    const auto at = [](const glm::dvec2& place) {
        return place.x < 1 / 3.0 ? 1.0 : place.x < 2 / 3.0 ? 0.5 : 0.0;
    };
    const auto dots = subdivided(
        tile, 9000, [](const auto&) { return 1.0; }, at);
    const auto dense = std::ranges::count_if(dots, [](const auto& dot) { return dot.place.x < 1 / 3.0; });
    CHECK(static_cast<double>(dots.size()) == doctest::Approx(4500).epsilon(0.02));
    CHECK(static_cast<double>(dense) == doctest::Approx(3000).epsilon(0.02));
    for (const auto& dot : dots) {
        CHECK(dot.place.x < 2 / 3.0);
        CHECK(dot.critical < 9000);
    }
}

TEST_CASE("annealing comes near to the best of all words") {
    const auto radius = [](const std::vector<std::uint8_t>& word) {
        const auto points = points_of_word<3, 2>(word);
        return relative_radius<glm::dvec2>(points);
    };
    double best = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed)
        best = std::max(best, radius(annealed_word<3, 2>(9, WordAim::radius, seed, 1500)));
    CHECK(best > 0.68);
    CHECK(best < 0.70011);
}

TEST_CASE("words that make no tile are refused") {
    CHECK_THROWS_WITH((make_cyclic_tile<2, 2>(letters_of("0123012x"))),
                      "letter 33 of a word: there are only 4");
    CHECK_THROWS_WITH((make_cyclic_tile<3, 2>(letters_of("0123"))),
                      "a word has to have each of 9 letters equally often");
    CHECK_THROWS_WITH((make_cyclic_tile<2, 2>(letters_of("03120312"))),
                      "a word may not be a repetition of a shorter one");
    CHECK_THROWS_WITH(letters_of("01-2"), "'-' is no letter of a word");
}

}  // namespace dapple
