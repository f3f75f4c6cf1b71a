#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/image/ink.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

const float kMostCovered = InkCurve().coverage(1);  // by dots of the full load

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
