#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lab/analysis/tone_fidelity.h"

using namespace dapple;

namespace {

Grid<float> waves(int width, int height) {
    Grid<float> grid(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            grid.at(x, y) = static_cast<float>(0.5 + 0.25 * std::sin(0.3 * x) * std::cos(0.2 * y));
    return grid;
}

}  // namespace

TEST_CASE("a picture compared with itself has no error and full similarity at every distance") {
    const Grid<float> picture = waves(60, 40);
    for (const double sigma : {0.0, 1.0, 7.5}) {
        const ToneFidelity same = tone_fidelity(picture, picture, sigma);
        CHECK(same.sigma_px == sigma);
        CHECK(same.mean_error == 0);
        CHECK(same.rms_error == 0);
        CHECK(same.psnr_db == 200);
        CHECK(same.ssim == doctest::Approx(1));
    }
}

TEST_CASE("a constant offset is the mean error, with its sign, and gives the closed form of SSIM") {
    const double a = 0.7, b = 0.5, c1 = 0.0001;
    const Grid<float> light(30, 20, 0.7f), dark(30, 20, 0.5f);
    for (const double sigma : {0.0, 3.0}) {
        const ToneFidelity lighter = tone_fidelity(light, dark, sigma);
        CHECK(lighter.mean_error == doctest::Approx(0.2));
        CHECK(lighter.rms_error == doctest::Approx(0.2));
        CHECK(lighter.psnr_db == doctest::Approx(-20 * std::log10(0.2)));
        CHECK(lighter.ssim == doctest::Approx((2 * a * b + c1) / (a * a + b * b + c1)).epsilon(1e-4));
        CHECK(tone_fidelity(dark, light, sigma).mean_error == doctest::Approx(-0.2));
    }
}

TEST_CASE("opposite patterns have negative similarity, and none once they are blurred away") {
    Grid<float> board(64, 64), opposite(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            board.at(x, y) = float((x + y) % 2);
            opposite.at(x, y) = 1 - board.at(x, y);
        }
    CHECK(tone_fidelity(board, opposite, 0).ssim < -0.9);
    CHECK(tone_fidelity(board, opposite, 0).rms_error == doctest::Approx(1));
    CHECK(tone_fidelity(board, opposite, 4).rms_error < 0.02);  // but for the edges, where pixels go on
    CHECK(tone_fidelity(board, opposite, 4).ssim > 0.9);
}

TEST_CASE("blur spreads a single pixel's error as a Gaussian does") {
    // The sum of a Gaussian's square is 1 / (4 pi sigma^2).
    Grid<float> black(201, 201, 0), spot = black;
    spot.at(100, 100) = 1;
    for (const double sigma : {2.0, 5.0, 10.0}) {
        const double mean_square = 1 / (4 * std::numbers::pi * sigma * sigma) / (201.0 * 201.0);
        CHECK(tone_fidelity(spot, black, sigma).rms_error ==
              doctest::Approx(std::sqrt(mean_square)).epsilon(0.03));
        CHECK(tone_fidelity(spot, black, sigma).mean_error == doctest::Approx(1 / (201.0 * 201.0)));
    }
}

TEST_CASE("light beyond paper and below black counts as paper and black") {
    CHECK(tone_fidelity(Grid<float>(4, 4, 1), Grid<float>(4, 4, 7), 0).rms_error == 0);
    CHECK(tone_fidelity(Grid<float>(4, 4, 0), Grid<float>(4, 4, -1), 0).rms_error == 0);
}

TEST_CASE("pictures of different sizes are refused, and none at all have no error") {
    CHECK_THROWS_WITH_AS(
        tone_fidelity(Grid<float>(4, 4), Grid<float>(4, 5), 0),
        "a drawing of 4 x 4 pixels and a photograph of 4 x 5 cannot be compared; draw it in the "
        "photograph's size",
        std::runtime_error);
    CHECK(tone_fidelity({}, {}, 1).ssim == 0);
}

TEST_CASE("a millimetre subtends a minute of arc from 3.44 metres away") {
    CHECK(viewing_distance(1) == doctest::Approx(3437.75).epsilon(1e-5));
    CHECK(viewing_distance(0.25) == doctest::Approx(3437.75 / 4).epsilon(1e-5));
}
