// What exposure a picture opens with, and that it comes before everything else.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/drawing/pipeline.h"
#include "core/image/auto_tone.h"
#include "core/image/histogram.h"

using namespace dapple;

namespace {

constexpr int kSide = 40;

// Light evenly from dark to light along the logarithm, so that its middle is 2^((from + to) / 2).
Grid<float> stops_between(double from, double to) {
    Grid<float> light(kSide, kSide);
    const auto last = static_cast<double>(light.values.size() - 1);
    for (std::size_t i = 0; i < light.values.size(); ++i)
        light.values[i] = static_cast<float>(std::exp2(from + (to - from) * static_cast<double>(i) / last));
    return light;
}

Grid<float> times(Grid<float> light, float factor) {
    for (float& v : light.values) v *= factor;
    return light;
}

float lightest(const Grid<float>& light) {
    return std::ranges::max(light.values);
}

}  // namespace

TEST_CASE("what could be a photograph is left as it is") {
    CHECK(usual_exposure(stops_between(-7, 0)) == 0);
    CHECK(usual_exposure(stops_between(-9, -2)) == 0);  // taken a little too dark
    CHECK(usual_exposure(Grid<float>(8, 8, 0)) == 0);
    CHECK(usual_exposure({}) == 0);
}

TEST_CASE("however bright or dark the light was, the same part of it is white") {
    const Grid<float> plain = stops_between(-6, 0);
    for (const float factor : {8.0f, 1000.0f, 1.0f / 64, 1e-5f}) {
        CAPTURE(factor);
        const Grid<float> light = times(plain, factor);
        const Grid<float> seen = exposed(light, usual_exposure(light));
        const auto white = std::ranges::count_if(seen.values, [](float v) { return v >= 1; });
        CHECK(static_cast<double>(white) / static_cast<double>(seen.values.size()) < 0.035);
        CHECK(lightest(seen) > 0.95f);
    }
}

TEST_CASE("a few lamps do not leave the room black, and fog is not bleached") {
    // A room of about 0.2 with lamps of 5000 on a twentieth of the picture.
    Grid<float> room = stops_between(-4, -0.6);
    for (std::size_t i = 0; i < room.values.size() / 20; ++i) room.values[i * 20] = 5000;
    const float room_exposure = usual_exposure(room);
    CHECK(room_exposure > -4);
    CHECK(room_exposure < 0);

    const Grid<float> fog = stops_between(3, 3.2);
    CHECK(lightest(exposed(fog, usual_exposure(fog))) < 0.45f);
}

TEST_CASE("black borders and pixels that are no numbers have no say") {
    Grid<float> light = times(stops_between(-6, 0), 100);
    const float before = usual_exposure(light);
    REQUIRE(before < -5);
    Grid<float> framed(light.width, 2 * light.height, 0);
    std::ranges::copy(light.values, framed.values.begin());
    framed.values.back() = NAN;
    CHECK(usual_exposure(framed) == before);
}

TEST_CASE("it is in tenths of a stop, as it can be typed") {
    const float stops = usual_exposure(times(stops_between(-6, 0), 77));
    CHECK(stops != 0);
    CHECK(stops * 10 == doctest::Approx(std::round(stops * 10)));
}

TEST_CASE("one stop is twice the light, and none leaves every value as it is") {
    const Grid<float> light = stops_between(-6, 3);
    CHECK(exposed(light, 0).values == light.values);
    CHECK(exposed(light, 1).values == times(light, 2).values);
    CHECK(exposed(light, -2).values == times(light, 0.25f).values);
}

TEST_CASE("a histogram is that of the light as exposed") {
    const Grid<float> light = stops_between(-3, 6);
    CHECK(histogram_of(light, -4) == histogram_of(exposed(light, -4)));
    CHECK(histogram_of(light, -4) != histogram_of(light));
}

TEST_CASE("a drawing is the one of light that is as much lighter, with detail and automatic tone too") {
    const Grid<float> light = stops_between(-6, 0), bright = times(light, 16);
    const auto plan_of = [](const Grid<float>& given, float usual, const DrawingSettings& request) {
        Pipeline pipeline;
        pipeline.set_tile(RankedTile(make_tile(14217, 2895, 16), RankingMethod::energy));
        pipeline.set_light(given, usual);
        return pipeline.plan(request);
    };
    for (const bool automatic_tone : {false, true}) {
        CAPTURE(automatic_tone);
        const auto request = [&](float stops) {
            return DrawingSettings{.automatic_tone = automatic_tone,
                                   .automatic_exposure = false,
                                   .tone = {.exposure = stops, .detail = 0.5f},
                                   .placing = {.count = 1000}};
        };
        const DrawingPlan plain = plan_of(light, 0, request(0)), down = plan_of(bright, 0, request(-4));
        CHECK(down.density->values().values == plain.density->values().values);
        CHECK(*down.histogram == *plain.histogram);
        CHECK(plan_of(bright, 0, request(0)).density->values().values != plain.density->values().values);

        // The usual one, unless told otherwise.
        DrawingSettings usual = request(0);
        usual.automatic_exposure = true;
        const DrawingPlan chosen = plan_of(bright, -4, usual);
        CHECK(chosen.tone.exposure == -4);
        CHECK(chosen.density->values().values == plain.density->values().values);
        CHECK(plan_of(bright, -4, request(0)).tone.exposure == 0);
    }
}

TEST_CASE("exposure that changes makes the density and the histogram anew") {
    Pipeline pipeline;
    pipeline.set_tile(RankedTile(make_tile(14217, 2895, 16), RankingMethod::energy));
    pipeline.set_light(stops_between(-6, 0));
    DrawingSettings request{.automatic_tone = false, .automatic_exposure = false, .placing = {.count = 1000}};
    const DrawingPlan first = pipeline.plan(request);
    request.tone.exposure = 1;
    const DrawingPlan lighter = pipeline.plan(request);
    CHECK(lighter.density->mean() < 0.95 * first.density->mean());
    CHECK(*lighter.histogram != *first.histogram);
}
