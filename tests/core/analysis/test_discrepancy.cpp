#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/report.h"
#include "tests/point_sets.h"

using namespace dapple;

namespace {

// By all corners that matter: coordinates of the points and 1.
double brute_force_star(const std::vector<glm::dvec2>& points) {
    std::vector<double> xs{1}, ys{1};
    for (const glm::dvec2 p : points) {
        xs.push_back(p.x);
        ys.push_back(p.y);
    }
    double greatest = 0;
    for (const double x : xs)
        for (const double y : ys) {
            double open = 0, closed = 0;
            for (const glm::dvec2 p : points) {
                open += p.x < x && p.y < y;
                closed += p.x <= x && p.y <= y;
            }
            const double n = double(points.size());
            greatest = std::max({greatest, x * y - open / n, closed / n - x * y});
        }
    return greatest;
}

double radical_inverse(unsigned i) {
    double value = 0;
    for (double digit = 0.5; i > 0; i >>= 1, digit /= 2) value += (i & 1) * digit;
    return value;
}

std::vector<glm::dvec2> hammersley(unsigned count) {
    std::vector<glm::dvec2> points;
    for (unsigned i = 0; i < count; ++i) points.push_back({double(i) / count, radical_inverse(i)});
    return points;
}

}  // namespace

TEST_CASE("the L2 star discrepancy of one point has a closed form") {
    for (const glm::dvec2 p : white_noise(20, 1)) {
        const double squared = 1.0 / 9 - (1 - p.x * p.x) * (1 - p.y * p.y) / 2 + (1 - p.x) * (1 - p.y);
        CHECK(l2_star_discrepancy(std::vector{p}, {}) == doctest::Approx(std::sqrt(squared)).epsilon(1e-12));
    }
    CHECK(l2_star_discrepancy(std::vector{glm::dvec2(1, 1)}, {}) == doctest::Approx(1.0 / 3));
    CHECK(l2_star_discrepancy({}, {}) == 0);
}

TEST_CASE("the L2 star discrepancy is Warnock's double sum, and the mean square over boxes") {
    std::vector<glm::dvec2> points = white_noise(150, 2);
    for (int i = 0; i < 20; ++i) points.push_back({points[i].x, points[i + 20].y});  // equal coordinates
    const double n = double(points.size());
    double warnock = 1.0 / 9;
    for (const glm::dvec2 p : points) {
        warnock -= (1 - p.x * p.x) * (1 - p.y * p.y) / (2 * n);
        for (const glm::dvec2 q : points)
            warnock += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y)) / (n * n);
    }
    CHECK(l2_star_discrepancy(points, {}) == doctest::Approx(std::sqrt(warnock)).epsilon(1e-10));

    double square = 0;
    constexpr int kSide = 300;
    for (int v = 0; v < kSide; ++v)
        for (int u = 0; u < kSide; ++u) {
            const double x = (u + 0.5) / kSide, y = (v + 0.5) / kSide;
            double inside = 0;
            for (const glm::dvec2 p : points) inside += p.x < x && p.y < y;
            square += (inside / n - x * y) * (inside / n - x * y);
        }
    CHECK(l2_star_discrepancy(points, {}) == doctest::Approx(std::sqrt(square) / kSide).epsilon(0.01));
}

TEST_CASE("white noise has the mean square discrepancy of independent points") {
    double square = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const double d = l2_star_discrepancy(white_noise(500, seed), {});
        square += d * d / 200;
    }
    CHECK(square == doctest::Approx(5.0 / 36 / 500).epsilon(0.2));
}

TEST_CASE("the star discrepancy is the one of all boxes at points") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        std::vector<glm::dvec2> points = white_noise(1 + int(seed) * 7, seed);
        if (seed % 3 == 0)  // equal coordinates, some of them 0 and 1
            for (glm::dvec2& p : points) p = {std::round(p.x * 8) / 8, std::round(p.y * 8) / 8};
        const StarDiscrepancy star = star_discrepancy(points, {});
        CHECK(star.lower == star.upper);
        CHECK(star.lower == doctest::Approx(brute_force_star(points)).epsilon(1e-12));
        if (seed % 6 != 3) continue;
        const StarDiscrepancy bounds = star_discrepancy(points, {}, 0);
        CHECK(bounds.lower <= star.lower + 1e-12);
        CHECK(bounds.upper >= star.upper - 1e-12);
        CHECK(bounds.upper - bounds.lower < 3.0 / 1024 + 2 / double(points.size()));
    }
}

TEST_CASE("the best place for one point is at the golden section") {
    // White 1976, "On optimal extreme-discrepancy point sets in the square": D* = (sqrt 5 - 1) / 2.
    const double golden = (std::sqrt(5.0) - 1) / 2;
    CHECK(star_discrepancy(std::vector{glm::dvec2(golden, golden)}, {}).upper == doctest::Approx(golden));
    CHECK(star_discrepancy(std::vector{glm::dvec2(golden, 0.5)}, {}).upper > golden);
}

TEST_CASE("Hammersley's points have the published discrepancy, in a domain of any size") {
    // Halton & Zaremba 1969, "The extreme and L2 discrepancies of some plane sets": for 2^m points,
    // m >= 2, (i / 2^m, inverse of i), 2^m D* = m / 3 + 13 / 9 - (-1)^m 4 / (9 2^m).
    for (unsigned m = 2; m <= 12; ++m) {
        auto points = hammersley(1u << m);
        const double n = double(points.size());
        const double published = m / 3.0 + 13.0 / 9 - (m % 2 == 0 ? 1 : -1) * 4 / (9 * n);
        CHECK(n * star_discrepancy(points, {}).upper == doctest::Approx(published).epsilon(1e-9));
        for (glm::dvec2& p : points) p *= glm::dvec2(3, 0.2);
        CHECK(n * star_discrepancy(points, {3, 0.2}).upper == doctest::Approx(published).epsilon(1e-9));
    }
}
