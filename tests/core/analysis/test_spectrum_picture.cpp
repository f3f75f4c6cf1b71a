#include <doctest/doctest.h>

#include "core/analysis/periodogram.h"
#include "tests/point_sets.h"

using namespace dapple;

namespace {

bool is_grey(glm::u8vec3 c) {
    return c.r == c.g && c.g == c.b;
}

int count_coloured(const Grid<glm::u8vec3>& picture) {
    int count = 0;
    for (const glm::u8vec3 c : picture.values) count += is_grey(c) ? 0 : 1;
    return count;
}

}  // namespace

TEST_CASE("a lattice's spectrum is black but for coloured peaks at its own frequencies") {
    // 32 x 32 points: bins up to 64 each way, peaks at multiples of 32, shown 3 pixels wide or more.
    const auto picture = spectrum_picture(periodogram(square_lattice(32), {}), 129);
    REQUIRE(picture.width == 129);
    REQUIRE(picture.height == 129);
    for (int y = 0; y < 129; ++y)
        for (int x = 0; x < 129; ++x) {
            const bool near_x = (x + 1) % 32 <= 2, near_y = (y + 1) % 32 <= 2;  // 64 - 32 k = 0 mod 32
            const bool centre = std::abs(x - 64) <= 1 && std::abs(y - 64) <= 1;
            CAPTURE(x);
            CAPTURE(y);
            if (near_x && near_y && !centre)
                CHECK_FALSE(is_grey(picture.at(x, y)));
            else
                CHECK(picture.at(x, y) == glm::u8vec3(0));
        }
}

TEST_CASE("white noise is grey, the same upside down, and black in the middle") {
    const auto picture = spectrum_picture(periodogram(white_noise(1000, 3), {}), 200);
    CHECK(picture.width == 127);  // 63 bins each way
    CHECK(count_coloured(picture) == 0);
    CHECK(picture.at(63, 63) == glm::u8vec3(0));
    double sum = 0;
    for (int y = 0; y < 127; ++y)
        for (int x = 0; x < 127; ++x) {
            CHECK(picture.at(x, y) == picture.at(126 - x, 126 - y));
            sum += picture.at(x, y).r;
        }
    CHECK(sum / (127 * 127) == doctest::Approx(53).epsilon(0.1));  // mean of log(1 + P), P exponential: 0.596
}

TEST_CASE("a peak survives shrinking, and small spectra are enlarged") {
    const auto large = spectrum_picture(periodogram(square_lattice(128), {}), 100);
    CHECK(large.width <= 100);
    CHECK(count_coloured(large) >= 8 * 4);
    const auto small = spectrum_picture(periodogram(square_lattice(2), {}), 100);
    CHECK(small.width > 50);
    CHECK(small.width <= 100);
    CHECK(spectrum_picture(periodogram({}, {}), 64).width == 64);
}
