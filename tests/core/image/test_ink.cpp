// The ink of drawings, measured on their pixels: does it cover as much paper as the picture asks for?

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/output/raster.h"
#include "io/files/tile_library.h"

using namespace dapple;

namespace {

constexpr double kWidthMm = 200;

Pipeline& pipeline_of(float light) {
    static Pipeline pipeline = [] {
        Pipeline result;
        result.set_tile(tile_named(kDefaultTile));
        return result;
    }();
    pipeline.set_light(Grid<float>(8, 8, light));
    return pipeline;
}

struct Measured {
    Grid<float> coverage;
    double apart = 0;  // mean distance between dots, in pixels
    std::size_t dots = 0;

    // Without so many of its rows and columns at each edge.
    double mean_within(double edge) const {
        const int from = static_cast<int>(edge), to = coverage.width - from;
        double sum = 0;
        for (int y = from; y < to; ++y)
            for (int x = from; x < to; ++x) sum += coverage.at(x, y);
        return sum / (double(to - from) * (to - from));
    }
};

// Light all over the page, drawn as it is.
Measured measured(float light, std::uint64_t count, int steps, bool by_tone, double dpmm = 1.5,
                  double black = 1) {
    Pipeline& pipeline = pipeline_of(light);
    DrawingSettings request{.automatic_tone = false,
                            .tone = {.black = black},
                            .placing = {.count = count, .threads = 0},
                            .relax = steps};
    request.page.width_mm = kWidthMm;
    if (by_tone) {
        // About so many on black.
        const double largest = kWidthMm * std::sqrt(1.5 / (std::numbers::pi * static_cast<double>(count)));
        request.dot_size = {
            .sizing = DotSizing::by_tone, .smallest_mm = 0.4 * largest, .largest_mm = largest};
    }
    const DrawingPlan plan = pipeline.plan(request);
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    REQUIRE(drawn.steps == steps);
    const double scale = drawn.scale;
    Measured result;
    result.dots = drawn.dots.size();
    result.coverage = coverage_of({.size = plan.page,
                                   .dots = stream_of(drawn.dots, scale),
                                   .dot_radius_mm = plan.radius(scale) * plan.page.mm_per_page_unit},
                                  {.dpi = 25.4 * dpmm, .threads = 0});
    result.apart = kWidthMm * dpmm / std::sqrt(double(result.dots));
    return result;
}

// The largest difference from what was asked for, at counts from one level of the tile to the next.
void check_coverage(int steps) {
    constexpr std::array kLights{0.02f, 0.9f, 0.2f, 0.5f, 0.98f, 0.3f, 0.05f, 0.7f, 0.4f, 0.8f};
    std::size_t next = 0;
    for (const bool by_tone : {false, true}) {
        for (const std::uint64_t count : {10'000u, 13'000u, 16'000u, 20'000u, 27'000u}) {
            // Where dots begin to overlap all at once, an error shows most.
            for (const float light : {0.1f, kLights[next++ % kLights.size()]}) {
                const Measured drawing = measured(light, count, steps, by_tone);
                CAPTURE(steps);
                CAPTURE(by_tone);
                CAPTURE(count);
                CAPTURE(light);
                CHECK(std::abs(drawing.mean_within(0.05 * drawing.coverage.width) - (1 - light)) < 0.01);
            }
        }
    }
}

}  // namespace

TEST_CASE("dots as placed cover what the picture asks for") {
    check_coverage(0);
}

TEST_CASE("dots relaxed once or twice cover what the picture asks for") {
    check_coverage(1);
    check_coverage(2);
}

TEST_CASE("dots relaxed three or four times cover what the picture asks for") {
    check_coverage(3);
    check_coverage(4);
}

TEST_CASE("dots relaxed the usual steps and more cover what the picture asks for") {
    check_coverage(kFewestUsualSteps);
    check_coverage(10);
}

TEST_CASE("black is covered to 99.5 % and more, of whatever size the dots, anywhere between two levels") {
    for (const int steps : {0, 1, 2, 3, 4, kFewestUsualSteps}) {
        for (const std::uint64_t count : {10'000u, 13'000u, 16'000u, 20'000u, 27'000u}) {
            CAPTURE(steps);
            CAPTURE(count);
            const Measured drawing = measured(0, count, steps, count == 16'000);
            CHECK(drawing.mean_within(0.05 * drawing.coverage.width) >= 0.995);
        }
    }
}

TEST_CASE("black has no bare fringe along the page's edges") {
    for (const int steps : {4, 10}) {
        for (const std::uint64_t count : {3000u, 5000u}) {
            const Measured drawing = measured(0, count, steps, false, 3);
            const int last = drawing.coverage.width - 1,
                      depth = static_cast<int>(std::lround(drawing.apart / 2));
            REQUIRE(depth >= 3);
            std::array<double, 4> edges{};
            for (int i = 0; i < depth; ++i) {
                for (int k = 0; k <= last; ++k) {
                    edges[0] += drawing.coverage.at(i, k);
                    edges[1] += drawing.coverage.at(last - i, k);
                    edges[2] += drawing.coverage.at(k, i);
                    edges[3] += drawing.coverage.at(k, last - i);
                }
            }
            for (const double edge : edges) {
                CAPTURE(steps);
                CAPTURE(count);
                CHECK(edge / (double(depth) * (last + 1)) >= 0.97);
            }
        }
    }
}

TEST_CASE("with sizes by tone, light greys have the more dots the smaller the smallest are") {
    Pipeline& pipeline = pipeline_of(0.8f);
    std::vector<std::size_t> counts;
    for (const double smallest : {0.2, 0.5, 1.0}) {
        Stippling drawn;
        REQUIRE(pipeline.draw(
            pipeline.plan(
                {.automatic_tone = false,
                 .relax = 1,
                 .dot_size = {.sizing = DotSizing::by_tone, .smallest_mm = smallest, .largest_mm = 1}}),
            drawn));
        counts.push_back(drawn.dots.size());
    }
    CHECK(counts[0] > counts[1]);
    CHECK(counts[1] > counts[2]);
    // All alike they have the tone that they have by themselves: a fifth of the page within its margins.
    CHECK(static_cast<double>(counts[2]) ==
          doctest::Approx(0.2 * 198 * 198 / std::numbers::pi).epsilon(0.005));
}

TEST_CASE(
    "lines through dots are twice as long, and so cover twice as much, where there are four times as many") {
    const InkCurve curve({.joined = true});
    for (const float coverage : {0.1f, 0.25f, 0.5f, 0.9f})
        CHECK(curve.density(coverage) == doctest::Approx(coverage * coverage).epsilon(1e-3));
    CHECK(curve.density(1) == 1);
}

TEST_CASE("a black that is less than solid is covered so far by dots that are hardly more than apart") {
    for (const int steps : {0, 2, 5, 30}) {
        CAPTURE(steps);
        for (const double black : {0.5, 0.8, 0.95}) {
            const InkCurve open({.relaxing_steps = steps, .black = black});
            CHECK(open.coverage(1) == doctest::Approx(black).epsilon(0.002));
            CHECK(open.full_load() < InkCurve({.relaxing_steps = steps}).full_load());
            CHECK(open.full_load() > 0.999 * black);  // no dots cover more than their area
        }
    }
    // A third of the load for the last fifth.
    CHECK(InkCurve({.relaxing_steps = 5, .black = 0.8}).full_load() == doctest::Approx(0.82).epsilon(0.02));
}

TEST_CASE("where black is open, light tones keep their ink and of two tones the darker one stays darker") {
    for (const double black : {0.5, 0.7, 0.9, 0.97}) {
        CAPTURE(black);
        const InkCurve curve({.relaxing_steps = 5, .black = black});
        CHECK(curve.opened(0) == 0);
        CHECK(curve.opened(1) == doctest::Approx(black));
        CHECK(curve.density_for(1) == doctest::Approx(1).epsilon(0.002));
        CHECK(curve.opened(0.1f) == doctest::Approx(0.1).epsilon(0.2));
        for (float ink = 0.01f; ink <= 1; ink += 0.01f) {
            CHECK(curve.opened(ink) - curve.opened(ink - 0.01f) >= 0.0029f);
            CHECK(curve.opened(ink) <= ink);
            CHECK(curve.coverage(curve.density_for(ink)) ==
                  doctest::Approx(curve.opened(ink)).epsilon(0.004));
        }
    }
    const InkCurve solid({.relaxing_steps = 5});
    for (const float ink : {0.0f, 0.3f, 0.9f, 1.0f}) CHECK(solid.opened(ink) == ink);
}

TEST_CASE("on a black page the paper that an open black leaves is as much as was asked") {
    for (const int steps : {0, 1, 5}) {
        for (const double black : {0.6, 0.8, 0.95}) {
            CAPTURE(steps);
            CAPTURE(black);
            CHECK(measured(0, 12'000, steps, false, 6, black).mean_within(40) ==
                  doctest::Approx(black).epsilon(0.015));
        }
    }
}
