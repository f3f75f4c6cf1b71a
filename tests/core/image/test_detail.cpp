#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "core/image/detail.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

// A picture of encoded values, as light.
template <class Value>
Grid<float> picture_of(int width, int height, Value value) {
    Grid<float> light(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) light.at(x, y) = srgb_to_linear(static_cast<float>(value(x, y)));
    return light;
}

double encoded_mean(const Grid<float>& light) {
    double sum = 0;
    for (float value : light.values) sum += linear_to_srgb(value);
    return sum / static_cast<double>(light.values.size());
}

double waves(int x, int y) {
    return 0.5 + 0.2 * std::sin(x * 0.31) * std::cos(y * 0.17) + 0.05 * std::sin(x * 1.3 + y);
}

}  // namespace

TEST_CASE("detail of 0 returns the very same picture") {
    Grid<float> light = picture_of(40, 30, waves);
    light.at(3, 4) = 7;
    light.at(5, 5) = std::numeric_limits<float>::quiet_NaN();
    const Grid<float> same = with_detail(light, 0, 3);
    CHECK(std::memcmp(same.values.data(), light.values.data(), light.values.size() * sizeof(float)) == 0);
    CHECK(with_detail({}, 1, 3).empty());
}

TEST_CASE("flat parts stay flat") {
    for (double grey : {0.0, 0.02, 0.4, 1.0}) {
        const Grid<float> light = picture_of(50, 40, [&](int, int) { return grey; });
        for (float value : with_detail(light, 1, 4).values)
            CHECK(std::abs(linear_to_srgb(value) - grey) < 1e-4);
    }
}

TEST_CASE("white stays white to the bit, and black black, however wide the means") {
    for (const double sigma : {1.0, 4.0, 7.0, 23.0}) {
        const Grid<float> light = picture_of(150, 140, [](int x, int y) {
            return x < 20 && y < 20 ? 0.5 : y < 70 ? 1.0 : 0.0;
        });
        const Grid<float> drawn = with_detail(light, 1, sigma);
        CHECK(drawn.at(149, 10) == 1);
        CHECK(drawn.at(149, 130) == 0);
    }
}

TEST_CASE("a faint line on grey gains contrast, the more the higher the amount") {
    const Grid<float> light = picture_of(80, 60, [](int x, int) { return x == 40 || x == 41 ? 0.45 : 0.5; });
    const auto contrast = [&](double amount) {
        const Grid<float> drawn = with_detail(light, amount, 4);
        return linear_to_srgb(drawn.at(10, 30)) - linear_to_srgb(drawn.at(40, 30));
    };
    CHECK(contrast(0) == doctest::Approx(0.05));
    CHECK(contrast(0.5) > 1.3 * contrast(0));
    CHECK(contrast(1) > 1.7 * contrast(0));
    CHECK(contrast(1) < 3 * contrast(0));
}

TEST_CASE("no value moves by more than the bound, and strong edges hardly have a halo") {
    // Against the bound that the header gives.
    const Grid<float> rough = picture_of(
        90, 70, [](int x, int y) { return 0.5 + 0.5 * std::sin(0.02 * x * y) * std::sin(x * 0.05); });
    const Grid<float> speck =
        picture_of(90, 70, [](int x, int y) { return x == 45 && y == 35 ? 0.75 : 0.4; });
    for (const Grid<float>& light : {rough, speck})
        for (double amount : {0.3, 1.0, 2.0}) {
            const Grid<float> drawn = with_detail(light, amount, 6);
            double most = 0;
            for (std::size_t i = 0; i < drawn.values.size(); ++i) {
                const double moved = linear_to_srgb(drawn.values[i]) - linear_to_srgb(light.values[i]);
                most = std::max(most, std::abs(moved));
            }
            CHECK(most <= amount * 0.15 + 1e-5);
        }
    const Grid<float> edge = picture_of(80, 20, [](int x, int) { return x < 40 ? 0.2 : 0.8; });
    const Grid<float> drawn = with_detail(edge, 1, 4);
    for (float value : drawn.values) {
        const float v = linear_to_srgb(value);
        CHECK(std::min(std::abs(v - 0.2f), std::abs(v - 0.8f)) < 0.06f);
    }
}

TEST_CASE("a steady slope stays as it is, pixel for pixel, also where means are worked out on fewer") {
    // Its mean about a place is its value there. The picture's edges, where it is not, are left out.
    constexpr int kLength = 200, kEdge = 60;
    constexpr double kSigma = 12;
    const auto value = [](int x, int y) { return 0.2f + 0.001f * static_cast<float>(x + y); };
    const Grid<float> detailed = with_detail(picture_of(kLength, kLength, value), 1, kSigma);
    float most = 0;
    for (int y = kEdge; y < kLength - kEdge; ++y)
        for (int x = kEdge; x < kLength - kEdge; ++x)
            most = std::max(most, std::abs(linear_to_srgb(detailed.at(x, y)) - value(x, y)));
    CHECK(most < 2e-4f);
}

TEST_CASE("detail keeps the mean lightness, and the light in 0..1") {
    const Grid<float> light = picture_of(120, 100, waves);
    CHECK(std::abs(encoded_mean(with_detail(light, 1, 4)) - encoded_mean(light)) < 0.002);
    Grid<float> odd = light;
    odd.at(7, 7) = std::numeric_limits<float>::quiet_NaN();
    odd.at(9, 9) = 50;
    odd.at(11, 9) = -50;
    for (float value : with_detail(odd, 1, 4).values) CHECK((value >= 0 && value <= 1));
}

TEST_CASE("a weak wave is amplified as the formula says") {
    // A Gaussian leaves exp(-(sigma w)^2 / 2) of a wave, so v - m is the rest of it. Far from the edges.
    for (const double sigma : {4.0, 8.0, 20.0, 40.0}) {
        CAPTURE(sigma);
        const double period = 4 * sigma, w = 2 * std::numbers::pi / period, height = 0.004;
        const Grid<float> light = picture_of(static_cast<int>(16 * period) + 3, 64,
                                             [&](int x, int) { return 0.5 + height * std::sin(w * x); });
        const Grid<float> drawn = with_detail(light, 1, sigma);
        const double rest = 1 - std::exp(-sigma * sigma * w * w / 2);
        const double peak = linear_to_srgb(drawn.at(static_cast<int>(8.25 * period), 32)) - 0.5;
        CHECK(peak == doctest::Approx(height * (1 + 1.5 * rest)).epsilon(0.04));
    }
}

TEST_CASE("detail's scale is four mean spacings of the dots") {
    CHECK(detail_sigma(40'000, 40'000) == doctest::Approx(4));
    CHECK(detail_sigma(1'000'000, 40'000) == doctest::Approx(22.63).epsilon(1e-3));  // 2^4.5, near 20
}
