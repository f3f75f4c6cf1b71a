#include "tests/bench/dot_marks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "tests/point_sets.h"

using namespace dapple;

namespace {

// What a square lattice's points have over the spacing of the hexagonal one.
const double kOfSquare = std::sqrt(std::sqrt(3.0) / 2);

}  // namespace

TEST_CASE("a square lattice's marks are those of its formulas") {
    const int side = 32;
    const DotMarks marks = dot_marks(square_lattice(side), 1.5);
    CHECK(marks.highest_bin == doctest::Approx(side * side));  // all power, at multiples of the side
    CHECK(marks.power_03 == doctest::Approx(0).epsilon(1e-6));
    CHECK(marks.power_05 == doctest::Approx(0).epsilon(1e-6));
    CHECK(marks.nearest.p1 == doctest::Approx(kOfSquare));
    CHECK(marks.nearest.mean == doctest::Approx(kOfSquare));
}

TEST_CASE("dots relax on the torus: a lattice stays, and it does not matter where the square begins") {
    constexpr int kSide = 32, kSteps = 3;
    constexpr double kScale = kSide * kSide / 16.0;
    const auto farthest = [](const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
        double most = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const glm::dvec2 d = a[i] - b[i];
            most = std::max({most, std::abs(d.x - std::round(d.x)), std::abs(d.y - std::round(d.y))});
        }
        return most;
    };
    const auto moved = [](std::vector<glm::dvec2> points) {
        for (glm::dvec2& p : points) p = glm::fract(p + glm::dvec2(0.5, 0.25));
        return points;
    };
    const auto lattice = square_lattice(kSide), noise = white_noise(kSide * kSide, 7);
    CHECK(farthest(relaxed_on_torus(lattice, kScale, kSteps), lattice) < 1e-4);
    const auto relaxed = relaxed_on_torus(noise, kScale, kSteps);
    CHECK(farthest(relaxed, noise) > 0.3 / kSide);
    CHECK(farthest(relaxed_on_torus(moved(noise), kScale, kSteps), moved(relaxed)) < 0.01 / kSide);
    CHECK(relaxed_on_torus(noise, kScale, 0) == noise);
}

TEST_CASE("one tile laid everywhere stays so in all steps of relaxation, but not if it is stirred first") {
    constexpr int kTiles = 8, kSteps = 4;
    constexpr double kScale = kTiles * kTiles * 64 / 16.0;
    std::vector<glm::dvec2> dots;
    for (const glm::dvec2 p : white_noise(64, 3))
        for (int i = 0; i < kTiles * kTiles; ++i)
            dots.push_back((p + glm::dvec2(i % kTiles, i / kTiles)) / double(kTiles));
    const auto alike = [](const std::vector<glm::dvec2>& points) {
        return coincidence(points, 1.0 / kTiles);
    };
    CHECK(alike(relaxed_on_torus(dots, kScale, kSteps)) > 0.9);
    const auto stirred = stirred_on_torus(dots, kScale);
    CHECK(std::ranges::all_of(stirred,
                              [](glm::dvec2 p) { return p.x >= 0 && p.y >= 0 && p.x <= 1 && p.y <= 1; }));
    CHECK(alike(relaxed_on_torus(stirred, kScale, kSteps)) < 0.2);
}

TEST_CASE("dots coincide as often as the tiles that were laid twice") {
    // 4 x 4 tiles, of which two are alike, (2, 1) apart.
    constexpr int kAlike[] = {0, 6};
    std::vector<glm::dvec2> dots;
    const auto lay = [&](int places, std::uint64_t seed) {
        for (const glm::dvec2 p : white_noise(500, seed))
            dots.push_back((p + glm::dvec2(places % 4, places / 4)) / 4.0);
    };
    for (int place = 0; place < 16; ++place) lay(place, std::ranges::count(kAlike, place) > 0 ? 99 : place);
    CHECK(coincidence(dots, 0.25) > 0.9 / 16);
    CHECK(coincidence(dots, 0.25) < 1.3 / 16);  // the worst of some hundred moves, with chance
    CHECK(coincidence(repeated(white_noise(500, 1), 4), 0.25) == doctest::Approx(1));
    CHECK(coincidence(white_noise(8000, 2), 0.25) < 0.02);
}
