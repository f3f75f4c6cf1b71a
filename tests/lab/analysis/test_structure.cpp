#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/image/tone.h"
#include "lab/analysis/ssim.h"
#include "lab/compare/structure.h"

using namespace dapple;

namespace {

// Rises by `slope` a pixel in the direction of that angle.
Grid<float> ramp(double degrees, double slope) {
    const double angle = degrees * std::numbers::pi / 180;
    Grid<float> grid(40, 30);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            grid.at(x, y) = float(0.5 + slope * ((x - 20) * std::cos(angle) + (y - 15) * std::sin(angle)));
    return grid;
}

Grid<float> waves(double contrast) {
    Grid<float> grid(90, 70);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            grid.at(x, y) = float(0.5 + contrast * std::sin(0.3 * x) * std::cos(0.2 * y));
    return grid;
}

}  // namespace

TEST_CASE("the gradients of two ramps correlate as the cosine of the angle between them") {
    for (const double degrees : {0.0, 30.0, 60.0, 90.0, 135.0, 180.0}) {
        CAPTURE(degrees);
        const double wanted = std::cos(degrees * std::numbers::pi / 180);
        CHECK(gradient_correlation(ramp(10, 0.01), ramp(10 + degrees, 0.01)) ==
              doctest::Approx(wanted).epsilon(1e-4));
    }
}

TEST_CASE("contrast and lightness leave the gradients' correlation, a negative turns it round") {
    Grid<float> lighter = waves(0.1);
    for (float& value : lighter.values) value += 0.3f;
    CHECK(gradient_correlation(waves(0.2), lighter) == doctest::Approx(1));
    CHECK(gradient_correlation(waves(0.2), waves(-0.2)) == doctest::Approx(-1));
    CHECK(gradient_correlation(waves(0.2), Grid<float>(90, 70, 0.5f)) == 0);
}

TEST_CASE("half of the gradients' energy in common is a correlation of one half") {
    // Two pictures that share one of two waves at right angles, each of equal energy.
    Grid<float> a(120, 120), b(120, 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x) {
            const double turn = 2 * std::numbers::pi / 120;
            const double common = std::sin(6 * turn * x);
            a.at(x, y) = float(0.5 + 0.1 * (common + std::sin(6 * turn * y)));
            b.at(x, y) = float(0.5 + 0.1 * (common + std::cos(6 * turn * y)));
        }
    CHECK(gradient_correlation(a, b) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("similarity of even greys is that of their encoded values") {
    const double a = linear_to_srgb(0.7f), b = linear_to_srgb(0.1f), c1 = 0.0001;
    const Structure greys = structure(Grid<float>(30, 20, 0.7f), Grid<float>(30, 20, 0.1f), 2);
    CHECK(greys.ssim == doctest::Approx((2 * a * b + c1) / (a * a + b * b + c1)).epsilon(1e-4));
}

TEST_CASE("similarity of a wave and the same at half contrast is the closed form") {
    // Over a window of whole waves: variances s^2 / 2 and s^2 / 8, covariance s^2 / 4, equal means.
    Grid<float> full(400, 8), half = full;
    const double s = 0.2;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 400; ++x) {
            const double wave = s * std::sin(std::numbers::pi / 2 * x + 0.4);
            full.at(x, y) = float(0.5 + wave);
            half.at(x, y) = float(0.5 + wave / 2);
        }
    const double c2 = 0.0009, wanted = (s * s / 2 + c2) / (s * s * 5 / 8 + c2);
    CHECK(mean_ssim(full, half, 6) == doctest::Approx(wanted).epsilon(0.01));
}

TEST_CASE("a picture has all of its own structure, and light beyond paper counts as paper") {
    for (const double sigma : {0.0, 1.0, 6.0}) {
        const Structure same = structure(waves(0.4), waves(0.4), sigma);
        CHECK(same.ssim == doctest::Approx(1));
        CHECK(same.gradients == doctest::Approx(1));
    }
    CHECK(structure(Grid<float>(9, 9, 7), Grid<float>(9, 9, 1), 1).ssim == doctest::Approx(1));
    CHECK(structure({}, {}, 1).ssim == 0);
}
