// Cells' marks against cells worked out by hand and against brute force; icons against their areas.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <numeric>
#include <vector>

#include "lab/compare/cell_marks.h"
#include "lab/compare/icons.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

const Density kEven(Grid<float>(8, 8, 0.5f));

double ink_of(const ComparedPicture& icon) {
    return 1 - std::accumulate(icon.light.values.begin(), icon.light.values.end(), 0.0) /
                   double(icon.light.values.size());
}

}  // namespace

TEST_CASE("a square lattice has a sixth of energy, and each dot its share and its centroid") {
    PlainDots lattice;
    for (int i = 0; i < 64; ++i) lattice.emplace_back((i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8);
    const CellMarks marks = cell_marks(lattice, kEven);
    CHECK(marks.energy == doctest::Approx(1.0 / 6));
    CHECK(marks.capacity < 1e-6);
    CHECK(marks.displacement < 1e-9);
}

TEST_CASE("two dots beside each other have the marks worked out by hand") {
    // Cells from 0 to 3/8 and on to 1: they weigh 1/2 -+ 1/8, and their centroids lie 1/16 and 3/16 away.
    const CellMarks marks = cell_marks({{0.25, 0.5}, {0.5, 0.5}}, kEven);
    const double across = (std::pow(0.25, 3) + std::pow(0.5, 3) + 2 * std::pow(0.125, 3)) / 3;
    CHECK(marks.energy == doctest::Approx(2 * (across + 1.0 / 12)));
    CHECK(marks.capacity == doctest::Approx(0.25));
    CHECK(marks.displacement == doctest::Approx(std::sqrt(2.0) / 8));
}

TEST_CASE("cells are weighed by the density, as pixels go to their nearest dots") {
    Grid<float> ramp(32, 16);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = float(x) / 40;
    const Density density(std::move(ramp));
    PlainDots dots = white_noise({.count = 12});
    for (glm::dvec2& dot : dots) dot.y /= 2;
    constexpr int kSide = 500;
    std::vector<glm::dvec3> sums(dots.size());  // weight, and weight times the way
    double energy = 0, weight = 0;
    for (int i = 0; i < kSide * kSide / 2; ++i) {
        const glm::dvec2 at((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < dots.size(); ++k)
            if (glm::distance(at, dots[k]) < glm::distance(at, dots[nearest])) nearest = k;
        const double w = density.at(at);
        sums[nearest] += w * glm::dvec3(1, at - dots[nearest]);
        energy += w * glm::dot(at - dots[nearest], at - dots[nearest]);
        weight += w;
    }
    double deviation = 0, displacement = 0;
    for (const glm::dvec3& sum : sums) {
        deviation += std::pow(sum.x * 12 / weight - 1, 2) / 12;
        displacement += glm::length(glm::dvec2(sum.y, sum.z)) / sum.x / 12;
    }
    const CellMarks marks = cell_marks(dots, density);
    CHECK(marks.energy == doctest::Approx(energy / weight * 24).epsilon(0.002));
    CHECK(marks.capacity == doctest::Approx(std::sqrt(deviation)).epsilon(0.002));
    CHECK(marks.displacement == doctest::Approx(displacement * std::sqrt(24.0)).epsilon(0.002));
}

TEST_CASE("icons have the ink that their shapes' areas come to, and paper around it") {
    const std::vector<ComparedPicture> all = icons();
    REQUIRE(all.size() == 5);
    for (const ComparedPicture& icon : all) {
        CAPTURE(icon.name);
        CHECK((ink_of(icon) > 0.1 && ink_of(icon) < 0.45));
        CHECK(icon.light.at(0, 0) == 1);
        CHECK(std::ranges::min(icon.light.values) < 0.35f);
    }
    // Ten triangles between a tip, a notch and the middle, of a page of area 4.
    CHECK(ink_of(all[0]) ==
          doctest::Approx(0.9 * 5 * 0.9 * 0.4 * std::sin(std::numbers::pi / 5) / 4).epsilon(0.01));
    // The disc's rim is dark to the right and light to the left.
    const int middle = kIconSide / 2;
    CHECK(all[3].light.at(middle + 100, middle) < 0.1f);
    CHECK(all[3].light.at(middle - 100, middle) > 0.9f);
}

}  // namespace dapple
