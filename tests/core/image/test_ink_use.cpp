#include <doctest/doctest.h>

#include "core/image/auto_tone.h"

using namespace dapple;

namespace {

// So many pixels of each encoded value.
struct Area {
    float encoded;
    std::uint64_t pixels;
};

Histogram histogram_of_areas(std::initializer_list<Area> areas) {
    Histogram histogram;
    for (const Area& area : areas) {
        histogram.counts[static_cast<int>(area.encoded * Histogram::kSteps + 0.5f)] += area.pixels;
        histogram.total += area.pixels;
    }
    return histogram;
}

bool mostly_black_at_first(const Histogram& histogram) {
    return mostly_black(histogram, auto_tone(histogram, {}));
}

}  // namespace

TEST_CASE("the mean ink is the light that the picture lacks") {
    const float grey = 0.5f;
    const Histogram histogram = histogram_of_areas({{grey, 300}, {1, 100}});
    CHECK(mean_ink(histogram, {}) == doctest::Approx(0.75 * (1 - srgb_to_linear(grey))).epsilon(1e-3));
    CHECK(mean_ink(histogram, {.invert = true}) ==
          doctest::Approx(0.25 * InkCurve().coverage(1) + 0.75 * srgb_to_linear(grey)).epsilon(1e-3));
    // Blur has no place to act on in a histogram.
    CHECK(mean_ink(histogram, {.blur = 50}) == mean_ink(histogram, {}));
}

TEST_CASE("the mean density is that of the picture") {
    const Histogram histogram = histogram_of_areas({{0.5f, 300}, {1, 100}});
    const InkCurve ink({.relaxing_steps = 5, .black = 0.8});
    CHECK(mean_density(histogram, {}, ink) ==
          doctest::Approx(0.75 * ink.density_for(1 - srgb_to_linear(0.5f))).epsilon(1e-3));
    CHECK(mean_density(histogram, {.invert = true}, ink) ==
          doctest::Approx(0.75 * ink.density_for(srgb_to_linear(0.5f)) + 0.25).epsilon(1e-3));
    CHECK(mean_density({}, {}, ink) == 0);
}

TEST_CASE("dots in black are counted by their density") {
    // Black has density 1; halves of the picture in black and white put all dots into black.
    CHECK(dots_in_black(histogram_of_areas({{0, 50}, {1, 50}}), {}) == 1);
    CHECK(dots_in_black(histogram_of_areas({{0.5f, 50}, {1, 50}}), {}) == 0);
    CHECK(dots_in_black(histogram_of_areas({{1, 50}}), {}) == 0);
    CHECK(dots_in_black({}, {}) == 0);
    // Where ink covers 0.4, the load is 0.406, and 2.05 on black.
    const Histogram two = histogram_of_areas({{0, 100}, {linear_to_srgb(0.6f), 400}});
    CHECK(dots_in_black(two, {}) == doctest::Approx(1 / (1 + 4 * 0.406 / 2.05)).epsilon(0.01));
}

TEST_CASE("a night sky is mostly black, unless its ink is light already") {
    const Histogram night = histogram_of_areas({{0.03f, 4000}, {0.05f, 4000}, {0.07f, 1800}, {0.9f, 200}});
    CHECK(mostly_black(night, {}));
    CHECK(mostly_black_at_first(night));
    CHECK_FALSE(mostly_black(night, {.invert = true}));
}

TEST_CASE("a dark portrait, a dusk, an underexposed photograph and a line drawing are not mostly black") {
    const Histogram portrait =
        histogram_of_areas({{0.02f, 3000}, {0.1f, 3000}, {0.3f, 1500}, {0.6f, 1500}, {0.8f, 1000}});
    const Histogram dusk = histogram_of_areas({{0.05f, 1000}, {0.2f, 4000}, {0.25f, 4000}, {0.9f, 1000}});
    const Histogram underexposed =
        histogram_of_areas({{0.02f, 2000}, {0.05f, 3000}, {0.1f, 3000}, {0.15f, 2000}});
    const Histogram lines = histogram_of_areas({{0, 500}, {1, 9500}});
    CHECK_FALSE(mostly_black_at_first(portrait));
    CHECK_FALSE(mostly_black_at_first(dusk));
    CHECK_FALSE(mostly_black_at_first(underexposed));
    CHECK_FALSE(mostly_black_at_first(lines));
    CHECK_FALSE(mostly_black({}, {}));
}
