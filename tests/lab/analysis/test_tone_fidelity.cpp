#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/output/raster.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"

using namespace dapple;

namespace {

// Means over so many cells a side: what is seen from afar.
Grid<double> from_afar(const Grid<float>& picture, int cells) {
    Grid<double> sums(cells, cells), counts(cells, cells);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int cx = x * cells / picture.width, cy = y * cells / picture.height;
            sums.at(cx, cy) += std::clamp(picture.at(x, y), 0.0f, 1.0f);
            counts.at(cx, cy) += 1;
        }
    }
    for (std::size_t i = 0; i < sums.values.size(); ++i) sums.values[i] /= counts.values[i];
    return sums;
}

// The light that is seen, one value a pixel, with black ink on white paper or, inverted, the other way round.
Grid<float> light_of_drawing(const Grid<float>& light, const DrawingSettings& settings) {
    Pipeline pipeline;
    pipeline.set_light(light);
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    DrawingSettings plain = settings;
    plain.automatic_tone = false;
    plain.tone.detail = 0;
    const DrawingPlan plan = pipeline.plan(plain);
    Stippling dots;
    REQUIRE(pipeline.draw(plan, dots));
    const double radius_mm = plan.radius(dots.scale) * plan.page.mm_per_page_unit;
    Grid<float> drawn =
        coverage_of({.size = plan.page, .dots = stream_of(dots.dots), .dot_radius_mm = radius_mm},
                    {.dpi = 150, .threads = 0});
    if (!settings.tone.invert)
        for (float& value : drawn.values) value = 1 - value;
    return drawn;
}

struct Error {
    double mean = 0, largest = 0;
};

Error error_of(const Grid<float>& light, const DrawingSettings& settings, int cells) {
    const Grid<double> wanted = from_afar(light, cells),
                       drawn = from_afar(light_of_drawing(light, settings), cells);
    Error error;
    for (std::size_t i = 0; i < wanted.values.size(); ++i) {
        const double difference = std::abs(wanted.values[i] - drawn.values[i]);
        error.mean += difference / static_cast<double>(wanted.values.size());
        error.largest = std::max(error.largest, difference);
    }
    return error;
}

Grid<float> ramp() {
    Grid<float> light(600, 600);
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 600; ++x) light.at(x, y) = static_cast<float>(x + 0.5) / 600;
    }
    return light;
}

}  // namespace

TEST_CASE("in true light a drawing seen from afar has the photograph's light") {
    const DrawingSettings settings;
    const Error of_ramp = error_of(ramp(), settings, 16),
                of_sample = error_of(sample_picture().light, settings, 16);
    CAPTURE(of_ramp.largest);
    CAPTURE(of_sample.largest);
    CHECK(of_ramp.mean < 0.015);
    CHECK(of_sample.mean < 0.015);
}

TEST_CASE("white ink on black paper, seen from afar, has the photograph's light too") {
    DrawingSettings settings;
    settings.tone.invert = true;
    CHECK(error_of(ramp(), settings, 16).mean < 0.015);
    CHECK(error_of(sample_picture().light, settings, 16).mean < 0.015);
}

TEST_CASE("the tone stays whatever the count, the width of the page and the order of the dots") {
    for (const std::uint64_t count : {5'000u, 20'000u, 80'000u}) {
        CAPTURE(count);
        DrawingSettings settings;
        settings.placing.count = count;
        CHECK(error_of(ramp(), settings, 10).mean < 0.02);
    }
    DrawingSettings postcard;
    postcard.page.width_mm = 148;
    CHECK(error_of(ramp(), postcard, 10).mean < 0.02);
    for (const RankingMethod method : {RankingMethod::paper, RankingMethod::farthest}) {
        DrawingSettings settings;
        settings.ranking = method;
        CHECK(error_of(ramp(), settings, 10).mean < 0.04);
    }
}
