#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "core/analysis/periodogram.h"
#include "tests/point_sets.h"

using namespace dapple;

namespace {

std::complex<double> direct_sum(const std::vector<glm::dvec2>& points, const Domain& domain, int i, int j) {
    std::complex<double> sum = 0;
    for (const glm::dvec2 p : points)
        sum += std::polar(1.0, -2 * std::numbers::pi * (i * p.x / domain.width + j * p.y / domain.height));
    return sum;
}

}  // namespace

TEST_CASE("the sums are those of the definition, exact and fast, on any rectangle") {
    const Domain domain{3, 0.7, Topology::torus};
    const auto points = white_noise(200, 5, domain);
    const glm::dvec2 period(domain.width, domain.height);
    const FourierSums exact = exact_fourier_sums(points, period, 21, 9);
    const FourierSums fast = fast_fourier_sums(points, period, 21, 9);
    for (int i = -21; i <= 21; i += 3)
        for (int j = -9; j <= 9; j += 3) {
            const std::complex<double> sum = direct_sum(points, domain, i, j);
            CHECK(std::abs(std::complex<double>(exact.at(i, j)) - sum) < 1e-5 * std::sqrt(200.0));
            CHECK(std::abs(std::complex<double>(fast.at(i, j)) - sum) < 1e-5 * std::sqrt(200.0));
        }
}

TEST_CASE("the fast power is within a thousandth of the exact one for white noise") {
    const auto points = white_noise(5000, 11);
    const Periodogram exact =
        periodogram(points, {}, {.highest_frequency = 0.6, .route = FourierRoute::exact});
    const Periodogram fast = periodogram(points, {}, {.highest_frequency = 0.6, .route = FourierRoute::fast});
    REQUIRE(exact.power.size() == fast.power.size());
    REQUIRE(exact.max_x == 42);
    double worst = 0;
    for (std::size_t k = 0; k < exact.power.size(); ++k)
        if (exact.power[k] > 0.1f)
            worst = std::max(worst, std::abs(double(fast.power[k]) / double(exact.power[k]) - 1));
    CHECK(worst < 1e-4);
}

TEST_CASE("the fast power does not see the peaks of a lattice where there are none") {
    const auto points = square_lattice(64);
    const Periodogram spectrum = periodogram(points, {}, {.route = FourierRoute::fast});
    REQUIRE(spectrum.max_x == 128);
    for (int i = -128; i <= 128; ++i)
        for (int j = -128; j <= 128; ++j) {
            if (i % 64 == 0 && j % 64 == 0)
                CHECK(double(spectrum.at(i, j)) == doctest::Approx(4096).epsilon(1e-4));
            else if (spectrum.at(i, j) >= 1e-4f)
                FAIL("power " << spectrum.at(i, j) << " at " << i << ", " << j);
        }
}

TEST_CASE("a square lattice has P = n at multiples of its frequency and 0 elsewhere") {
    const Periodogram spectrum = periodogram(square_lattice(12), {}, {.route = FourierRoute::exact});
    REQUIRE(spectrum.max_x == 24);
    for (int i = -24; i <= 24; ++i)
        for (int j = -24; j <= 24; ++j)
            CHECK(std::abs(double(spectrum.at(i, j)) - (i % 12 == 0 && j % 12 == 0 ? 144 : 0)) < 1e-4);
}

TEST_CASE("a comb of points on a line has its Bragg peaks on one axis") {
    // 40 points, each at x = m / 8 for some m: P(8 i, 0) = n.
    std::vector<glm::dvec2> points = white_noise(40, 2);
    for (std::size_t m = 0; m < points.size(); ++m) points[m].x = double(m % 8) / 8;
    const Periodogram spectrum = periodogram(points, {});
    CHECK(double(spectrum.at(8, 0)) == doctest::Approx(40).epsilon(1e-6));
    CHECK(double(spectrum.at(-8, 0)) == doctest::Approx(40).epsilon(1e-6));
    CHECK(double(spectrum.at(4, 0)) == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("a hexagonal lattice peaks on its own six reciprocal points of a rectangle") {
    const PointSet set = hexagonal_lattice(40, 24);  // 1920 points: fast
    const Periodogram spectrum = periodogram(set.points, set.domain);
    for (const auto& [i, j] : {std::pair{40, 24}, {40, -24}, {0, 48}, {-40, 24}})
        CHECK(double(spectrum.at(i, j)) == doctest::Approx(1920).epsilon(1e-4));
    CHECK(spectrum.at(40, 0) < 1e-3f);
    // All six at the same length: sqrt(2 / sqrt(3)) sqrt(n).
    CHECK(spectrum.squared_frequency(40, 24) == doctest::Approx(1920 * 2 / std::sqrt(3.0)));
    CHECK(spectrum.squared_frequency(0, 48) == doctest::Approx(1920 * 2 / std::sqrt(3.0)));
}

TEST_CASE("a spectrum of nothing or of too much is an answer or a sentence") {
    CHECK(periodogram({}, {}).power.size() == 1);
    const auto few = white_noise(10, 1);
    CHECK(periodogram(few, {}, {.highest_frequency = 0}).power.front() == 10);
    CHECK_THROWS_AS(periodogram(few, {}, {.highest_frequency = 1e5}), std::runtime_error);
}
