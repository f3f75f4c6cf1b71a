#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "core/image/histogram.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

constexpr float kHalfBin = 0.5f / Histogram::kSteps;

// Light whose encoded values are skewed, as photographs' are.
Grid<float> noisy_picture(int width, int height) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    Grid<float> light(width, height);
    for (float& value : light.values) value = srgb_to_linear(std::pow(uniform(random), 2.5f));
    return light;
}

}  // namespace

TEST_CASE("percentiles are those of the sorted pixels, to half a bin") {
    const Grid<float> light = noisy_picture(211, 173);
    std::vector<float> sorted;
    for (float value : light.values) sorted.push_back(linear_to_srgb(value));
    std::ranges::sort(sorted);
    const Histogram histogram = histogram_of(light);
    REQUIRE(histogram.total == sorted.size());
    for (double percent : {0.0, 0.01, 0.5, 10.0, 50.0, 73.0, 99.5, 99.99, 100.0}) {
        CAPTURE(percent);
        const double rank = std::ceil(percent / 100 * static_cast<double>(sorted.size()));
        const float expected = sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
        CHECK(std::abs(percentile(histogram, percent) - expected) < kHalfBin + 1e-5f);
    }
}

TEST_CASE("each 8-bit value has a bin of its own") {
    Grid<float> light(256, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 256; ++x)
            light.at(x, y) = srgb_to_linear(static_cast<float>((x * 7) % 256) / 255);
    const Histogram histogram = histogram_of(light);
    for (int i = 0; i <= Histogram::kSteps; ++i) CHECK(histogram.counts[i] == (i % 4 == 0 ? 3 : 0));
}

TEST_CASE("NaN and values over 1 count as white, values below 0 as black") {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                    kInfinity = std::numeric_limits<float>::infinity();
    Grid<float> light(6, 1);
    light.values = {0.2f, kNan, 7, kInfinity, -3, -kInfinity};
    const Histogram histogram = histogram_of(light);
    CHECK(histogram.counts.front() == 2);
    CHECK(histogram.counts.back() == 3);
    CHECK(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}) == 6);
    CHECK(histogram.total == 6);
}

TEST_CASE("a frame of one tone is left out") {
    const Grid<float> inside = noisy_picture(90, 60);
    for (float tone : {0.0f, 0.3f, 1.0f}) {
        Grid<float> framed(190, 100, tone);
        for (int y = 0; y < inside.height; ++y)
            for (int x = 0; x < inside.width; ++x) framed.at(x + 70, y + 10) = inside.at(x, y);
        CHECK(histogram_of(framed) == histogram_of(inside));
    }
}

TEST_CASE("a picture of one tone is all counted, an empty one has no percentiles") {
    const Histogram grey = histogram_of(Grid<float>(40, 30, srgb_to_linear(0.6f)));
    CHECK(grey.total == 1200);
    CHECK(percentile(grey, 0) == doctest::Approx(0.6));
    CHECK(percentile(grey, 100) == doctest::Approx(0.6));
    CHECK(histogram_of({}).total == 0);
    CHECK(percentile({}, 50) == 0);
}
