#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/image/auto_tone.h"
#include "core/image/ink.h"

using namespace dapple;

namespace {

// Pixels whose encoded value is value(u), u being spread evenly over 0..1.
template <class Value>
Grid<float> picture_of(Value value) {
    Grid<float> light(251, 199);
    for (std::size_t i = 0; i < light.values.size(); ++i) {
        // Evenly spread by the golden ratio, so that no row is of one tone.
        const double u = std::fmod(static_cast<double>(i) * 0.6180339887498949, 1.0);
        light.values[i] = srgb_to_linear(static_cast<float>(value(u)));
    }
    return light;
}

Tone auto_tone_of(const Grid<float>& light, const Tone& own = {}) {
    return auto_tone(histogram_of(light), own);
}

// What ink covers in the drawing, pixel by pixel.
double drawn_ink(const Grid<float>& light, const Tone& tone) {
    double sum = 0;
    const Grid<float> density = density_of(light, tone);
    const InkCurve curve;
    for (float value : density.values) sum += curve.coverage(value);
    return sum / static_cast<double>(density.values.size());
}

// Encoded values u^power between two tones.
Grid<float> skewed(double power, double black = 0, double white = 1) {
    return picture_of([=](double u) { return black + (white - black) * std::pow(u, power); });
}

// The ink that covers the paper for one encoded value.
float ink_for(float encoded, const Tone& tone) {
    const Grid<float> density = density_of(Grid<float>(1, 1, srgb_to_linear(encoded)), tone);
    return InkCurve().coverage(density.at(0, 0));
}

}  // namespace

TEST_CASE("an even gradient is stretched to its ends and covers half of the way to a balanced page") {
    const Tone tone = auto_tone_of(skewed(1, 0.2, 0.7));
    CHECK(tone.black_point == doctest::Approx(0.2025).epsilon(0.01));
    CHECK(tone.white_point == doctest::Approx(0.6975).epsilon(0.01));
    // Coverage 1 - e over an even spread has mean 1/2, half of the way to 0.42 is 0.46, and the mean of
    // 1 - e^m is m / (1 + m): m = 0.85. The encoding is only nearly a power, hence the tolerance.
    CHECK(2.2 / tone.gamma == doctest::Approx(0.85).epsilon(0.05));
}

TEST_CASE("the ink in the drawing is the ink aimed at") {
    for (double power : {0.7, 1.0, 1.5, 2.0}) {
        CAPTURE(power);
        const Grid<float> light = skewed(power);
        const Tone tone = auto_tone_of(light);
        Tone even = tone;
        even.gamma = 2.2f;
        const double expected = std::clamp(0.42 + (drawn_ink(light, even) - 0.42) / 2, 0.30, 0.62);
        CHECK(drawn_ink(light, tone) == doctest::Approx(expected).epsilon(0.003));
        CHECK(mean_ink(histogram_of(light), tone) == doctest::Approx(drawn_ink(light, tone)).epsilon(0.002));
    }
}

TEST_CASE("a darker photograph stays darker, and gamma has its limits") {
    double ink = 0;
    for (double power : {0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 20.0}) {
        CAPTURE(power);
        const Grid<float> light = skewed(power);
        const Tone tone = auto_tone_of(light);
        CHECK(drawn_ink(light, tone) > ink);
        ink = drawn_ink(light, tone);
        CHECK(tone.gamma >= 2.2f / 1.6f - 1e-3f);
        CHECK(tone.gamma <= 2.2f / 0.6f + 1e-3f);
    }
    CHECK(ink > 0.8);
}

TEST_CASE("one tone, nearly one tone and no picture keep the neutral tone") {
    for (float encoded : {0.0f, 0.02f, 0.5f, 1.0f})
        CHECK(auto_tone_of(Grid<float>(50, 40, srgb_to_linear(encoded))) == Tone{});
    CHECK(auto_tone_of(skewed(1, 0.6, 0.615)) == Tone{});
    CHECK(auto_tone(Histogram{}, {}) == Tone{});
    CHECK(auto_tone_of(Grid<float>(9, 9, std::nanf(""))) == Tone{});
    CHECK(mean_ink({}, {}) == 0);
}

TEST_CASE("what is not chosen stays as it was, and what was chosen before does not matter") {
    const Tone own{.contrast = 0.2f, .brightness = -0.1f, .blur = 3, .invert = true};
    Tone chosen_before = own;
    chosen_before.black_point = 0.4f;
    chosen_before.white_point = 0.5f;
    chosen_before.gamma = 3;
    const Tone tone = auto_tone_of(skewed(2), own);
    CHECK(auto_tone_of(skewed(2), chosen_before) == tone);
    CHECK(tone.contrast == own.contrast);
    CHECK(tone.brightness == own.brightness);
    CHECK(tone.blur == own.blur);
    CHECK(tone.invert);
}

TEST_CASE("a few thin grey lines on white become black on white") {
    for (double share : {0.0005, 0.003, 0.05}) {
        CAPTURE(share);
        const Grid<float> light = picture_of([=](double u) { return u < share ? 0.4 : 1.0; });
        const Tone tone = auto_tone_of(light);
        CHECK(ink_for(0.4f, tone) > 0.95f);
        CHECK(ink_for(1.0f, tone) < 1e-6f);
    }
}

TEST_CASE("the paper of a scanned page draws few dots, its letters all") {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.02);
    const Grid<float> light = picture_of([&](double u) { return (u < 0.1 ? 0.15 : 0.9) + noise(random); });
    const Tone tone = auto_tone_of(light);
    CHECK(ink_for(0.9f, tone) < 0.01f);
    CHECK(ink_for(0.15f, tone) > 0.9f);
}

TEST_CASE("a night sky stays dark in either ink, and light ink leaves its noise out") {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.05, 0.012);
    const Grid<float> light = picture_of([&](double u) { return u < 0.002 ? 0.95 : noise(random); });
    const Tone dark_ink = auto_tone_of(light), light_ink = auto_tone_of(light, {.invert = true});
    CHECK(drawn_ink(light, dark_ink) > 0.7);
    CHECK(drawn_ink(light, light_ink) < 0.05);
    CHECK(ink_for(0.05f, light_ink) == 0);
    CHECK(ink_for(0.95f, light_ink) > 0.9f);
}

TEST_CASE("fog stays fog") {
    const Tone tone = auto_tone_of(skewed(1, 0.7, 0.75));
    CHECK(tone.white_point - tone.black_point == doctest::Approx(0.12));
    CHECK((tone.white_point + tone.black_point) / 2 == doctest::Approx(0.725).epsilon(0.01));
    const Tone white_fog = auto_tone_of(skewed(1, 0.93, 1));
    CHECK(white_fog.white_point == 1);
    CHECK(white_fog.black_point == doctest::Approx(0.88));
}

TEST_CASE("light ink is never spread wider than the encoded value says") {
    for (double power : {0.2, 0.5, 1.0, 2.0, 4.0})
        CHECK(auto_tone_of(skewed(power), {.invert = true}).gamma <= 2.2f + 1e-3f);
}

TEST_CASE("at no strength automatic tone is true light, and at half of it lies half of the way") {
    for (const bool invert : {false, true}) {
        CAPTURE(invert);
        const Grid<float> light = skewed(2, 0.1, 0.8);
        const Histogram histogram = histogram_of(light);
        const Tone own{.contrast = 0.1f, .invert = invert};
        const Tone all = auto_tone(histogram, own), half = auto_tone(histogram, own, 0.5);
        CHECK(auto_tone(histogram, own, 0) == own);
        CHECK(half.black_point == doctest::Approx(all.black_point / 2));
        CHECK(1 - half.white_point == doctest::Approx((1 - all.white_point) / 2));
        CHECK(half.gamma * half.gamma == doctest::Approx(all.gamma));
        CHECK(half.contrast == own.contrast);
    }
}
