#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/image/ink.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

const float kMostCovered = InkCurve().coverage(1);  // by dots of the full load

// IEC 61966-2-1: the light of a grey as a photo editor counts it, 0 black to 1 white.
double light_of(double grey) {
    return grey <= 0.04045 ? grey / 12.92 : std::pow((grey + 0.055) / 1.055, 2.4);
}

// The nearest of 256 steps, by the inverse of the same formula.
int byte_of(double light) {
    const double grey = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(grey * 255));
}

// Light from black to white, one value a pixel.
Grid<float> greys() {
    Grid<float> light(201, 1);
    for (int x = 0; x < light.width; ++x) light.at(x, 0) = static_cast<float>(x) / 200;
    return light;
}

// The share of paper that the ink covers.
Grid<float> ink_of(const Grid<float>& light, const Tone& tone) {
    Grid<float> ink = density_of(light, tone);
    for (float& value : ink.values) value = InkCurve().coverage(value);
    return ink;
}

}  // namespace

TEST_CASE("light is the nearest of 256 encoded greys, wherever it lies between them") {
    for (int i = 0; i <= 1'000'000; ++i) {
        const float light = static_cast<float>(i) * 1e-6f;
        // A float's formula may round the other way where two steps are as near.
        const double low = byte_of(light * (1 - 1e-5)), high = byte_of(light * (1 + 1e-5));
        const int byte = srgb_byte(light);
        if (byte < low || byte > high) FAIL_CHECK(i << ": " << byte);
    }
    for (int byte = 0; byte < 256; ++byte)
        CHECK(srgb_byte(static_cast<float>(light_of(byte / 255.0))) == byte);
    CHECK(srgb_byte(-1) == 0);
    CHECK(srgb_byte(7) == 255);
    CHECK(srgb_byte(std::nanf("")) == 0);
}

TEST_CASE("dark ink covers the light that the picture lacks, light ink the light that it has") {
    const Grid<float> light = greys(), dark_ink = ink_of(light, {}),
                      light_ink = ink_of(light, {.invert = true});
    for (int x = 0; x < light.width; ++x) {
        CAPTURE(light.at(x, 0));
        CHECK(std::abs(dark_ink.at(x, 0) - std::min(1 - light.at(x, 0), kMostCovered)) < 1e-3);
        CHECK(std::abs(light_ink.at(x, 0) - std::min(light.at(x, 0), kMostCovered)) < 1e-3);
    }
}

TEST_CASE("a slider does the same to what is seen in dark ink and in light ink") {
    for (const Tone& tone : {Tone{.black_point = 0.3f}, Tone{.white_point = 0.6f}, Tone{.contrast = 0.4f},
                             Tone{.brightness = 0.2f}, Tone{.brightness = -0.2f}, Tone{.gamma = 2}}) {
        Tone inverted = tone;
        inverted.invert = true;
        const Grid<float> dark_ink = ink_of(greys(), tone), light_ink = ink_of(greys(), inverted);
        for (int x = 0; x < dark_ink.width; ++x) {
            // No ink covers all, so near its own end each is a little short.
            const float seen = std::clamp(light_ink.at(x, 0), 1 - kMostCovered, kMostCovered);
            CHECK(std::abs(std::clamp(1 - dark_ink.at(x, 0), 1 - kMostCovered, kMostCovered) - seen) < 1e-3);
        }
    }
}

TEST_CASE("each setting makes of a grey the grey that it stands for") {
    struct Expected {
        const char* setting;
        Tone tone;
        double before, after;
    };
    for (const Expected& e :
         {Expected{"none", {}, 0.5, 0.5}, Expected{"black point", {.black_point = 0.3f}, 0.5, 0.2 / 0.7},
          Expected{"black point", {.black_point = 0.3f}, 0.3, 0},
          Expected{"white point", {.white_point = 0.8f}, 0.5, 0.625},
          Expected{"both points", {.black_point = 0.2f, .white_point = 0.8f}, 0.35, 0.25},
          Expected{"brightness", {.brightness = 0.2f}, 0.5, 0.7},
          Expected{"brightness below 0", {.brightness = -0.2f}, 0.5, 0.3},
          Expected{"gamma", {.gamma = 2}, 0.36, 0.6}, Expected{"gamma below 1", {.gamma = 0.5f}, 0.6, 0.36},
          // The line's angle against the level: 45 degrees at 0, 67.5 at 0.5, level at -1.
          Expected{"contrast", {.contrast = 0.5f}, 0.4, 0.5 - 0.1 * std::tan(67.5 * std::numbers::pi / 180)},
          Expected{"contrast below 0",
                   {.contrast = -0.5f},
                   0.4,
                   0.5 - 0.1 * std::tan(22.5 * std::numbers::pi / 180)},
          Expected{"no contrast", {.contrast = -1}, 0.1, 0.5}}) {
        CAPTURE(std::string(e.setting));
        CAPTURE(e.before);
        const Grid<float> light(1, 1, static_cast<float>(light_of(e.before)));
        CHECK(std::abs(1 - ink_of(light, e.tone).at(0, 0) - light_of(e.after)) <
              (e.after == 0 ? 1.001 - static_cast<double>(kMostCovered) : 1e-3));
    }
}

TEST_CASE("blur spreads an edge as a Gaussian of so many thousandths of the longer side does") {
    for (const bool upright : {false, true}) {
        Grid<float> light = upright ? Grid<float>(40, 400) : Grid<float>(400, 40);
        for (int y = 0; y < light.height; ++y)
            for (int x = 0; x < light.width; ++x) light.at(x, y) = (upright ? y : x) < 200 ? 0.3f : 0.8f;
        for (const double sigma : {4.0, 10.0}) {
            CAPTURE(upright);
            CAPTURE(sigma);
            const Grid<float> ink = ink_of(light, {.blur = static_cast<float>(sigma * 1000 / 400)});
            for (int at = 150; at < 250; ++at) {
                const double past_edge = (at + 0.5 - 200) / sigma,
                             seen = 0.55 + 0.25 * std::erf(past_edge / std::numbers::sqrt2);
                CHECK(std::abs(1 - (upright ? ink.at(20, at) : ink.at(at, 20)) - seen) < 0.006);
            }
        }
    }
}
