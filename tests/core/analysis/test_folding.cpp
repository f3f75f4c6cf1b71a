#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/analysis/autocorrelation.h"
#include "tests/point_sets.h"

namespace dapple {
namespace {

// Every pair, on the torus of one period.
double repetition_by_all_pairs(const Folding& folding, double tolerance) {
    const std::vector<glm::dvec2>& points = folding.points;
    const auto n = static_cast<double>(points.size());
    const double radius = tolerance * std::sqrt(folding.layers / n);
    const auto apart = [](double a, double b) {
        const double d = std::abs(a - b);
        return std::min(d, 1 - d);
    };
    double met = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j)
            met += i != j &&
                   std::hypot(apart(points[i].x, points[j].x), apart(points[i].y, points[j].y)) <= radius;
    const double chance = (n - 1) * std::numbers::pi * radius * radius;
    return (met / n - chance) / (folding.layers - 1 - chance);
}

double mean_of(const Grid<float>& picture) {
    return std::accumulate(picture.values.begin(), picture.values.end(), 0.0) /
           static_cast<double>(picture.values.size());
}

// So many points alike in each of k x k periods of 1/k.
std::vector<glm::dvec2> wallpaper(int k, int points) {
    std::vector<glm::dvec2> set;
    for (const glm::dvec2 p : white_noise(points, 3))
        for (int y = 0; y < k; ++y)
            for (int x = 0; x < k; ++x) set.push_back((p + glm::dvec2(x, y)) / static_cast<double>(k));
    return set;
}

}  // namespace

TEST_CASE("a lattice folded by its spacing falls into one place") {
    const Folding folding = folded(square_lattice(16), {0, 0}, 1.0 / 16, 16);
    CHECK(folding.layers == 256);
    REQUIRE(folding.points.size() == 256);
    for (const glm::dvec2 p : folding.points) {
        CHECK(std::abs(p.x - folding.points[0].x) < 1e-9);
        CHECK(std::abs(p.y - folding.points[0].y) < 1e-9);
    }
    CHECK(repetition(folding) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("folding keeps the square's own points only, wherever it begins") {
    const std::vector<glm::dvec2> points{{0.5, 0.5}, {0.75, 0.5}, {0.99, 0.99}, {1.0, 0.6}, {0.49, 0.6}};
    const Folding folding = folded(points, {0.5, 0.5}, 0.25, 2);
    REQUIRE(folding.points.size() == 3);
    CHECK(folding.points[0] == glm::dvec2(0, 0));
    CHECK(folding.points[1] == glm::dvec2(0, 0));
    CHECK(folding.points[2].x == doctest::Approx(0.96));
}

TEST_CASE("white noise folds into an even one") {
    const Folding folding = folded(white_noise(20'000, 11), {0, 0}, 1.0 / 8, 8);
    CHECK(folding.points.size() == 20'000);
    CHECK(std::abs(repetition(folding)) < 0.01);
    // Each quarter of the period gets a quarter of the points, to four standard deviations.
    for (int q = 0; q < 4; ++q) {
        const auto here = std::ranges::count_if(folding.points, [&](glm::dvec2 p) {
            return (p.x >= 0.5) == (q % 2 == 1) && (p.y >= 0.5) == (q / 2 == 1);
        });
        CHECK(std::abs(static_cast<double>(here) - 5000) < 4 * std::sqrt(20'000 * 0.25 * 0.75));
    }
}

TEST_CASE("the repetition of a folding is what comparing all pairs gives") {
    for (const double tolerance : {0.1, 0.3}) {
        CAPTURE(tolerance);
        for (const auto& points : {white_noise(600, 5), wallpaper(4, 20), square_lattice(25)}) {
            const Folding folding = folded(points, {0, 0}, 0.25, 4);
            CHECK(repetition(folding, tolerance) ==
                  doctest::Approx(repetition_by_all_pairs(folding, tolerance)).epsilon(1e-12));
        }
    }
}

TEST_CASE("a set of which half repeats and half is noise has a repetition of a half") {
    std::vector<glm::dvec2> points = wallpaper(8, 40);
    for (const glm::dvec2 p : white_noise(40 * 64, 9)) points.push_back(p);
    const Folding folding = folded(points, {0, 0}, 1.0 / 8, 8);
    CHECK(repetition(folding, 0.02) == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("one layer, or nothing in it, has no repetition") {
    CHECK(repetition(folded(white_noise(100, 1), {0, 0}, 1, 1)) == 0);
    CHECK(repetition({}) == 0);
    CHECK(repetition(folded({}, {0, 0}, 0.5, 2)) == 0);
}

TEST_CASE("the mean of the layers is crisp for a lattice and keeps the ink of any set") {
    const Folding lattice = folded(square_lattice(16), {0, 0}, 1.0 / 16, 16);
    const Grid<float> crisp = mean_of_layers(lattice, 0.25, 128);
    for (const float value : crisp.values) CHECK((value < 1e-6f || value > 1 - 1e-4f));
    CHECK(mean_of(crisp) == doctest::Approx(std::numbers::pi / 16).epsilon(0.01));
    // So few and small dots that they seldom lie on one another: the ink is count x area.
    const Folding noise = folded(white_noise(512, 2), {0, 0}, 1.0 / 16, 16);
    const Grid<float> even = mean_of_layers(noise, 0.05, 256);
    CHECK(mean_of(even) == doctest::Approx(512.0 / 256 * std::numbers::pi * 0.0025).epsilon(0.01));
    CHECK(*std::ranges::max_element(even.values) < 0.1f);
}

}  // namespace dapple
