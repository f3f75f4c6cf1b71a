// Gaussian blue noise against plain descent by brute force, as its authors' program goes.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "lab/related/gaussian_blue_noise.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

// All pairs with their images next to them: the energy a dot beyond that of an even grey, and which way each
// dot is pushed. The deviation of a pair's kernel is the distance between dots.
struct Pushed {
    double energy = -2 * std::numbers::pi;
    PlainDots forces;
};
Pushed by_brute_force(const PlainDots& dots) {
    const double count = double(dots.size());
    Pushed result{.forces = PlainDots(dots.size())};
    for (std::size_t i = 0; i < dots.size(); ++i) {
        for (std::size_t j = 0; j < dots.size(); ++j) {
            for (int image = 0; image < 9; ++image) {
                const glm::dvec2 way = dots[i] - dots[j] + glm::dvec2(image % 3 - 1, image / 3 - 1);
                const double kernel = std::exp(-count * glm::dot(way, way) / 2);
                result.energy += kernel / count;
                result.forces[i] += kernel * way;
            }
        }
    }
    return result;
}

}  // namespace

TEST_CASE(
    "Gaussian blue noise lies far below what a thousand plain steps of the authors' come to, and still") {
    const DotsWanted wanted{.count = 36};
    PlainDots plain = white_noise(wanted);
    for (int step = 0; step < 1000; ++step) {
        const Pushed pushed = by_brute_force(plain);
        for (std::size_t i = 0; i < plain.size(); ++i)
            plain[i] = on_unit_torus(plain[i] + 0.25 * pushed.forces[i]);
    }
    const PlainDots dots = gaussian_blue_noise(wanted);
    const Pushed pushed = by_brute_force(dots);
    CHECK(pushed.energy > 0);
    CHECK(pushed.energy < by_brute_force(plain).energy / 4);
    CHECK(by_brute_force(plain).energy < by_brute_force(white_noise(wanted)).energy / 1000);
    double length = 0;
    for (const glm::dvec2 force : pushed.forces) length += glm::length(force) * 6 / 36;
    CHECK(length < 2e-5);
}

TEST_CASE("Gaussian blue noise keeps the distances, and has none of the waves, that its energy asks for") {
    const PlainDots dots = gaussian_blue_noise({.count = 400});
    const NearestSummary nearest = nearest_summary(dots, Domain{});
    CHECK(nearest.minimum > 0.65);
    CHECK(nearest.mean > 0.84);
    CHECK(low_frequency_power(periodogram(dots, Domain{}), 0.5) < 1e-4);
}

}  // namespace dapple
