// From a request to a drawing: what is chosen for the picture, what is made again, and what a stream gives.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/image/auto_tone.h"
#include "core/image/tone.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

// Light of a dull photograph: neither black nor white in it.
Grid<float> dull() {
    Grid<float> light(90, 60);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x)
            light.at(x, y) = srgb_to_linear(
                static_cast<float>(0.45 + 0.2 * std::sin(0.08 * x) * std::cos(0.1 * y) + 0.1 * x / 90));
    return light;
}

Grid<float> ramp() {
    Grid<float> light(80, 40);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) light.at(x, y) = static_cast<float>(x) / 79;
    return light;
}

RankedTile paper_tile() {
    return RankedTile(make_tile(14217, 2895, 16), RankingMethod::energy);
}

Pipeline pipeline_of(Grid<float> light) {
    Pipeline pipeline;
    pipeline.set_tile(paper_tile());
    pipeline.set_light(std::move(light));
    return pipeline;
}

Dots drawn_by(Pipeline& pipeline, const DrawingPlan& plan) {
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    CHECK(drawn.steps == plan.steps);
    return joined(drawn.dots);
}

// How that plan's dots settle, which are 0.4 mm to 1 mm large if they have sizes.
RelaxingRequest settling(const DrawingPlan& plan, double scale, bool sized) {
    static const RankedTile tile = paper_tile();
    RelaxingRequest request{.scale = scale,
                            .areas = {.smallest = sized ? 0.16f : 1},
                            .stirring = stirring_of(tile.placer().table(), scale),
                            .light = std::make_shared<const InkCurve>(plan.ink)};
    // Even where discs of all dots there would fill so much paper.
    request.even_from = request.areas.tone_of(static_cast<float>(kSolidLoad / plan.full_load));
    return request;
}

bool same(const Dots& a, const Dots& b) {
    return a.x == b.x && a.y == b.y && a.threshold == b.threshold && a.critical == b.critical &&
           a.radius == b.radius;
}

const DotSize kByTone{.sizing = DotSizing::by_tone, .smallest_mm = 0.4, .largest_mm = 1.0};

}  // namespace

TEST_CASE("automatic tone is the one for the picture, and an explicit one is taken as it is") {
    Pipeline pipeline = pipeline_of(dull());
    const Tone own{.black_point = 0.2f, .contrast = 0.1f, .gamma = 3, .blur = 2, .detail = 0.3f};
    const Tone chosen = auto_tone(histogram_of(dull()), own);
    CHECK(chosen.black_point > 0.25f);
    CHECK(chosen != own);
    const auto tone_drawn = [&](bool automatic) {
        Tone tone = pipeline
                        .plan({.automatic_tone = automatic,
                               .tone_strength = 1,
                               .tone = own,
                               .placing = {.count = 1000}})
                        .tone;
        CHECK(tone.black == (automatic ? usual_black(1000) : 1));
        tone.black.reset();
        return tone;
    };
    CHECK(tone_drawn(true) == chosen);
    CHECK(tone_drawn(false) == own);
    // On another picture it is another.
    pipeline.set_light(ramp());
    CHECK(tone_drawn(true) == auto_tone(histogram_of(ramp()), own));
}

TEST_CASE(
    "black is as solid as was asked, or as the number of dots allows; sizes by tone and lines decide it") {
    Pipeline pipeline = pipeline_of(ramp());
    const auto black = [&](const DrawingSettings& settings) {
        const DrawingPlan plan = pipeline.plan(settings);
        return *plan.tone.black;
    };
    for (const std::uint64_t few : {500, 5'000})
        CHECK(black({.tone_strength = 1, .placing = {.count = few}}) == 0.9);
    CHECK(black({.tone_strength = 1, .placing = {.count = 20'000}}) == 0.95);
    CHECK(black({.tone_strength = 1, .placing = {.count = 44'721}}) == 0.97);
    CHECK(black({.tone_strength = 1, .placing = {.count = 100'000}}) == 1);
    CHECK(black({.automatic_tone = false, .placing = {.count = 5'000}}) == 1);
    CHECK(black({.tone_strength = 0.5, .placing = {.count = 5'000}}) == doctest::Approx(0.95));
    CHECK(black({.tone_strength = 0, .placing = {.count = 5'000}}) == 1);
    for (const bool automatic : {true, false})
        CHECK(black({.automatic_tone = automatic, .tone = {.black = 0.7}, .placing = {.count = 5'000}}) ==
              0.7);
    CHECK(black({.tone = {.black = 0.7}, .dot_size = kByTone}) == 1);
    CHECK(black({.tone = {.black = 0.7}, .placing = {.count = 5'000}, .style = DrawingStyle::line}) == 1);
}

TEST_CASE("a crop in pixels is one of the file's, of which several became one") {
    const Crop crop{{{20, 10}, {100, 60}}, Crop::Unit::pixels}, in_light{{{10, 5}, {50, 30}}};
    Pipeline pipeline = pipeline_of(ramp()), large = pipeline_of(ramp());
    large.set_light(ramp(), 0, 2);
    CHECK(large.pixels() == glm::ivec2(160, 80));
    const auto dots_of = [](Pipeline& drawing, const Crop& part) {
        return drawn_by(drawing, drawing.plan({.placing = {.count = 500}, .page = {.crop = part}}));
    };
    CHECK(same(dots_of(large, crop), dots_of(pipeline, in_light)));
    CHECK(large.framing().pixels.high == glm::ivec2(100, 60));
    // A value that the crop meets is drawn whole.
    CHECK(same(dots_of(large, {{{21, 11}, {99, 59}}}), dots_of(pipeline, in_light)));
}

TEST_CASE("a scale draws with the black of as many dots, and so the same ones") {
    Pipeline pipeline = pipeline_of(dull());
    for (const std::uint64_t count : {10'000u, 26'000u, 40'000u, 60'000u, 200'000u}) {
        CAPTURE(count);
        DrawingPlan by_count = pipeline.plan({.placing = {.count = count}, .relax = 5});
        const DrawingPlan by_scale =
            pipeline.plan({.placing = {.scale = pipeline.find_scale(by_count)}, .relax = 5});
        CHECK(by_scale.tone.black == by_count.tone.black);
        CHECK(by_scale.density->values().values == by_count.density->values().values);
        CHECK(by_scale.full_load == by_count.full_load);
    }
}

TEST_CASE("with an open black fewer dots are in the dark, more in the light, and all are smaller") {
    Pipeline pipeline = pipeline_of(ramp());
    for (const int steps : {0, 2, 5}) {
        CAPTURE(steps);
        const auto dots_of = [&](double black) {
            DrawingPlan plan = pipeline.plan({.automatic_tone = false,
                                              .tone = {.black = black},
                                              .placing = {.count = 8'000, .threads = 0},
                                              .relax = steps});
            const Dots dots = drawn_by(pipeline, plan);
            return std::pair(std::ranges::count_if(dots.x, [](float x) { return x < 0.25f; }),
                             plan.radius(pipeline.find_scale(plan)));
        };
        const auto [solid, largest] = dots_of(1);
        const auto [open, smaller] = dots_of(0.8);
        CHECK(open < 0.92 * static_cast<double>(solid));
        CHECK(smaller < largest);
    }
}

TEST_CASE(
    "automatic tone lightens a picture in coloured pens half the way, so that its colours stay strong") {
    Pipeline pipeline = pipeline_of(dull());
    ColourGrid colours(90, 60);
    for (glm::u16vec3& colour : colours.values) colour = packed({0.4f, 0.3f, 0.2f});
    const auto gamma_with = [&](const char* pens) {
        return pipeline.plan({.tone_strength = 1, .placing = {.count = 1000}, .pens = parse_pens(pens)})
            .tone.gamma;
    };
    const float grey = auto_tone(histogram_of(dull()), {}).gamma;
    REQUIRE(std::abs(grey - 1) > 0.1f);
    CHECK(gamma_with("cmyk") == grey);  // the picture has no colours
    pipeline.set_colours(colours);
    CHECK(gamma_with("cmyk") == doctest::Approx(std::sqrt(grey)));
    CHECK(gamma_with("greys") == grey);
    CHECK(gamma_with("one") == grey);
}

TEST_CASE("true light is covered by as much ink as the picture lacks light") {
    Pipeline pipeline = pipeline_of(ramp());
    const DrawingPlan plan =
        pipeline.plan({.automatic_tone = false, .placing = {.count = 20'000}, .relax = 5});
    const InkCurve ink({.relaxing_steps = 5});
    for (int x = 0; x < 80; ++x)
        CHECK(std::abs(ink.coverage(plan.density->values().at(x, 20)) - (1 - ramp().at(x, 20))) < 0.005);
    CHECK(plan.full_load == ink.full_load());
}

TEST_CASE("steps are those asked for, or the usual ones, and Figure 8's dots stay as placed") {
    Pipeline pipeline = pipeline_of(ramp());
    const auto steps = [&](std::uint64_t count, std::optional<int> relax,
                           PlacerKind placer = PlacerKind::exact) {
        return pipeline.plan({.placer = placer, .placing = {.count = count}, .relax = relax}).steps;
    };
    for (const int n : {0, 1, 7, 100}) CHECK(steps(5000, n) == n);
    // 7 of 40,000 dots, and more of fewer by the root of their number, but no more than 12.
    CHECK(steps(100, {}) == 12);
    CHECK(steps(13'600, {}) == 12);
    CHECK(steps(20'000, {}) == 10);
    CHECK(steps(40'000, {}) == 7);
    CHECK(steps(1'900'000, {}) == 7);
    CHECK(steps(50'000'000, {}) == 0);
    CHECK(steps(50'000'000, 2) == 2);
    CHECK(steps(5000, {}, PlacerKind::figure8) == 0);
    CHECK(steps(5000, 3, PlacerKind::figure8) == 0);
    // On a wall so many can be seen: 10 m wide, 1 mm apart.
    CHECK(pipeline.plan({.placing = {.count = 50'000'000}, .page = {.width_mm = 10'000}}).steps == 7);
    // By a scale as by the count that it comes to.
    for (const double scale : {1000, 11'000, 30'000, 50'000'000}) {
        const DrawingPlan plan = pipeline.plan({.placing = {.scale = scale, .count = {}}});
        CHECK(plan.steps == steps(static_cast<std::uint64_t>(expected_dots(*plan.density, scale)), {}));
    }
    CHECK(usual_steps(3e6, 3e6) == 7);
    CHECK(usual_steps(3e6, 2e4) == 0);
    // What is usual is known where others are asked for.
    const DrawingPlan own = pipeline.plan({.placing = {.count = 80'000}, .relax = 3});
    CHECK(own.steps == 3);
    CHECK(own.usual_steps == 7);
}

TEST_CASE(
    "a stream gives the drawing dot for dot, by count, by scale, relaxed or not, with sizes or without") {
    Pipeline pipeline = pipeline_of(ramp());
    std::vector<DrawingSettings> requests;
    for (const int relax : {0, 2}) {
        requests.push_back({.placing = {.count = 4000, .thresholds = true}, .relax = relax});
        requests.push_back({.placing = {.scale = 500, .count = {}, .threads = 2}, .relax = relax});
        requests.push_back({.relax = relax, .dot_size = kByTone});
    }
    requests.push_back({.placer = PlacerKind::figure8, .placing = {.scale = 300, .count = {}}});
    requests.push_back({.placer = PlacerKind::figure8, .placing = {.count = {}}, .dot_size = kByTone});
    for (const DrawingSettings& request : requests) {
        const DrawingPlan plan = pipeline.plan(request);
        Stippling drawn;
        REQUIRE(pipeline.draw(plan, drawn));
        const Dots dots = joined(drawn.dots);
        const DotStream stream = pipeline.stream(plan);
        CHECK(dots.size() > 600);
        CHECK(same(all_of(stream), dots));
        CHECK(stream.count == dots.size());
        CHECK(stream.scale == drawn.scale);
        CHECK(stream.duplicates == drawn.duplicates);
        CHECK(drawn.steps == plan.steps);
    }
}

TEST_CASE("a drawing is the placed dots, relaxed") {
    Pipeline pipeline = pipeline_of(dull());
    const DrawingPlan plan = pipeline.plan({.placing = {.count = 2500, .thresholds = true}, .relax = 3});
    RankedTile tile = paper_tile();
    Stippling placed;
    REQUIRE(stipple(tile, *plan.density, PlacerKind::exact, {.count = 2500, .thresholds = true}, placed));
    REQUIRE(relax(placed.dots, *plan.density, 3, settling(plan, placed.scale, false)));
    CHECK(same(drawn_by(pipeline, plan), joined(placed.dots)));
}

TEST_CASE(
    "dots with sizes by tone settle by their ink, on any number of threads, in a stream as in a drawing") {
    Pipeline pipeline = pipeline_of(ramp());
    const auto request = [](int threads) {
        return DrawingSettings{.placing = {.count = {}, .threads = threads}, .relax = 6, .dot_size = kByTone};
    };
    const DrawingPlan plan = pipeline.plan(request(1));
    const Dots dots = drawn_by(pipeline, plan);
    RankedTile tile = paper_tile();
    Stippling placed;
    REQUIRE(stipple(tile, *plan.density, PlacerKind::exact, plan.placing, placed));
    REQUIRE(relax(placed.dots, *plan.density, 6, settling(plan, placed.scale, true)));
    const Dots settled = joined(placed.dots);
    CHECK(dots.x == settled.x);
    CHECK(dots.y == settled.y);
    CHECK(same(drawn_by(pipeline, pipeline.plan(request(3))), dots));
    CHECK(same(all_of(pipeline.stream(plan)), dots));
}

TEST_CASE("what a scale came to is known when it is asked for again, and no longer with another picture") {
    // Both have the same tones, but the mask leaves the light half of one and the dark half of the other.
    Grid<float> mirrored = ramp();
    for (int y = 0; y < mirrored.height; ++y) std::reverse(mirrored.row(y), mirrored.row(y) + mirrored.width);
    Grid<std::uint8_t> right_half(80, 40, kNeutralLevel);
    for (int y = 0; y < 40; ++y) std::fill_n(right_half.row(y), 40, std::uint8_t{0});
    const DrawingSettings request{
        .automatic_tone = false, .mask = Mask(right_half), .placing = {.scale = 20'000, .count = {}}};
    Pipeline pipeline = pipeline_of(ramp());
    const DrawingPlan first = pipeline.plan(request), again = pipeline.plan(request);
    CHECK(pipeline.tone_ms() == 0);
    CHECK(again.density == first.density);
    CHECK(again.steps == first.steps);
    CHECK(again.full_load == first.full_load);
    pipeline.set_light(mirrored);
    const DrawingPlan other = pipeline.plan(request), fresh = pipeline_of(mirrored).plan(request);
    CHECK(other.steps == fresh.steps);
    CHECK(other.density->values().values == fresh.density->values().values);
    CHECK(other.steps < first.steps);
}

TEST_CASE("what a change has no say in is not made again") {
    Pipeline pipeline = pipeline_of(dull());
    // What brings out detail follows from the count.
    DrawingSettings request{.tone_strength = 1, .tone = {}, .placing = {.count = 4000}, .relax = 5};
    const auto density = [&] { return pipeline.plan(request).density; };
    auto last = density();
    const auto stays = [&] { return density() == last; };
    CHECK(pipeline.tone_ms() > 0);
    CHECK(stays());
    CHECK(pipeline.tone_ms() == 0);
    request.placing.count = 900;
    CHECK(stays());
    request.placing.threads = 2;
    CHECK(stays());
    request.page.width_mm = 90;
    CHECK(stays());
    request.dot_size = {.sizing = DotSizing::fixed, .radius_mm = 0.5};
    CHECK(stays());
    pipeline.set_tile(paper_tile());
    CHECK(stays());

    const auto changes = [&] {
        const auto now = density();
        const bool changed = now != last && now->values().values != last->values().values;
        last = now;
        return changed;
    };
    request.tone.contrast = 0.3f;
    CHECK(changes());
    request.automatic_tone = false;
    CHECK(changes());
    request.relax = 10;  // evener dots cover more
    CHECK(changes());
    request.dot_size = kByTone;
    CHECK(changes());
    request.dot_size = {};
    request.relax = 1;
    CHECK(changes());
    request.placing.count = 41'000;  // hardly relaxed dots cover by their count
    CHECK(changes());
    request.tone.detail = 0.5f;
    CHECK(changes());
    request.tone.black = 0.8;
    CHECK(changes());
    request.relax = 4;
    CHECK(changes());
    request.placing.count = 10'000;  // detail has the dots' scale
    CHECK(changes());
    pipeline.set_light(ramp());
    CHECK(changes());
}

TEST_CASE("a density of one's own is drawn as it is, whatever the tone") {
    Pipeline pipeline = pipeline_of(dull());
    const auto picture = pipeline.plan({.placing = {.count = 1000}}).density;
    Grid<float> grey(30, 60, 0.25f);
    pipeline.set_plain(Density(grey));
    const DrawingPlan plan =
        pipeline.plan({.tone = {.contrast = 0.5f}, .placing = {.count = 1000}, .page = {.width_mm = 100}});
    CHECK(plan.density->values().values == grey.values);
    CHECK(plan.tone == Tone{.contrast = 0.5f, .black = 1});
    CHECK(plan.page.height_mm == doctest::Approx(200));
    CHECK(plan.page.mm_per_page_unit == doctest::Approx(200));
    pipeline.set_plain({});
    CHECK(pipeline.plan({.placing = {.count = 1000}}).density->values().values == picture->values().values);
}

TEST_CASE("sizes by tone lie between the smallest and the largest, and grow with the density") {
    Pipeline pipeline = pipeline_of(ramp());
    for (const int steps : {0, 4}) {
        const DrawingPlan plan =
            pipeline.plan({.automatic_tone = false, .relax = steps, .dot_size = kByTone});
        const Dots dots = drawn_by(pipeline, plan);
        REQUIRE(dots.radius.size() == dots.size());
        const double mm = plan.page.mm_per_page_unit;
        // By density, radii rise.
        std::vector<std::pair<double, double>> sizes;
        for (std::size_t i = 0; i < dots.size(); ++i)
            sizes.emplace_back(plan.density->at({dots.x[i], dots.y[i]}), dots.radius[i] * mm);
        std::ranges::sort(sizes);
        CHECK(sizes.front().second >= 0.4 * (1 - 1e-6));
        CHECK(sizes.front().second < 0.5);
        CHECK(sizes.back().second <= 1.0 * (1 + 1e-6));
        CHECK(sizes.back().second > 0.98);
        for (std::size_t i = 1; i < sizes.size(); ++i) CHECK(sizes[i].second >= sizes[i - 1].second - 1e-6);
        // The ink is that of the tone: half the area of the page, less what overlaps.
        double area = 0;
        for (const auto& [density, radius] : sizes) area += 3.14159265 * radius * radius;
        CHECK(area / (plan.page.width_mm * plan.page.height_mm) > 0.5);
        CHECK(area / (plan.page.width_mm * plan.page.height_mm) < 0.8);
    }
}

TEST_CASE("how many dots there are follows from their sizes") {
    Pipeline pipeline = pipeline_of(ramp());
    const auto count = [&](double smallest, double largest, double width, std::uint64_t asked) {
        const DotSize size{.sizing = DotSizing::by_tone, .smallest_mm = smallest, .largest_mm = largest};
        return static_cast<double>(
            all_of(pipeline.stream(pipeline.plan({.tone_strength = 1,
                                                  .tone = {},
                                                  .placing = {.count = asked},
                                                  .relax = 3,
                                                  .dot_size = size,
                                                  .page = {.width_mm = width, .margins = Margins{}}})))
                .size());
    };
    const double usual = count(0.5, 1, 200, 7);
    CHECK(count(0.5, 1, 200, 5000) == usual);  // what was asked for has no say
    CHECK(count(0.25, 0.5, 200, 7) == doctest::Approx(4 * usual).epsilon(0.02));
    CHECK(count(0.5, 1, 400, 7) == doctest::Approx(4 * usual).epsilon(0.02));
    CHECK(count(0.25, 1, 200, 7) > 1.1 * usual);  // smaller ones in light areas: more of them
}

TEST_CASE("a plan says how large its dots are") {
    Pipeline pipeline = pipeline_of(ramp());
    const DrawingSettings request{.placing = {.count = 5000}, .relax = 4, .page = {.width_mm = 160}};
    DrawingSettings fixed = request, by_tone = request;
    fixed.dot_size = {.sizing = DotSizing::fixed, .radius_mm = 0.8};
    by_tone.dot_size = kByTone;
    // On a page of 160 x 80 mm, whose usual margins leave the picture that much less of its height.
    CHECK(pipeline.plan(fixed).radius(123) == doctest::Approx(0.8 / (2 * (80 - 2 * 0.8))));
    CHECK(pipeline.plan(by_tone).radius(123) == doctest::Approx(1.0 / (2 * (80 - 2 * 1.0))));
    // On black, dots of that radius have full_load of the page's area.
    const DrawingPlan plan = pipeline.plan(request);
    const double radius = plan.radius(100);
    CHECK(1600 * 3.14159265 * radius * radius == doctest::Approx(plan.full_load));
}

TEST_CASE("a stream outlives the pipeline") {
    for (const DrawingSettings& request :
         {DrawingSettings{.placing = {.count = 2000}, .relax = 0},
          {.placing = {.count = 2000}, .relax = 2},
          {.relax = 1, .dot_size = kByTone},
          {.placer = PlacerKind::figure8, .placing = {.scale = 200, .count = {}}}}) {
        auto pipeline = std::make_unique<Pipeline>(pipeline_of(ramp()));
        const Dots dots = drawn_by(*pipeline, pipeline->plan(request));
        const DotStream stream = pipeline->stream(pipeline->plan(request));
        const DotStream again = stream;
        pipeline.reset();
        CHECK(same(all_of(stream), dots));
        CHECK(same(all_of(again), dots));
    }
}

TEST_CASE("more dots than there may be are lowered to the most") {
    Pipeline pipeline = pipeline_of(ramp());
    constexpr std::uint64_t few = 5000;
    DrawingSettings request{.placing = {.count = 3000}, .relax = 3};
    CHECK_FALSE(pipeline.plan(request, few).lowered);
    request.placing.count = 5001;
    DrawingPlan plan = pipeline.plan(request, few);
    CHECK(plan.lowered);
    CHECK(plan.placing.count == 5000);
    request.placing = {.scale = 1e6, .count = {}};
    plan = pipeline.plan(request, few);
    CHECK(plan.lowered);
    CHECK(double(drawn_by(pipeline, plan).size()) == doctest::Approx(5000).epsilon(0.02));
    request.dot_size = {.sizing = DotSizing::by_tone, .smallest_mm = 0.05, .largest_mm = 0.1};
    plan = pipeline.plan(request, few);
    CHECK(plan.lowered);
    CHECK(double(drawn_by(pipeline, plan).size()) == doctest::Approx(5000).epsilon(0.02));
    // Figure 8 emits some dots twice.
    request = {.placer = PlacerKind::figure8, .placing = {.scale = 1e6, .count = {}}};
    plan = pipeline.plan(request, few);
    CHECK(plan.lowered);
    const std::size_t emitted = drawn_by(pipeline, plan).size();
    CHECK(emitted <= 5000);
    CHECK(emitted > 3000);
}

TEST_CASE("whoever watches sees every step but the last, with its dots") {
    Pipeline pipeline = pipeline_of(ramp());
    for (const bool sized : {false, true}) {
        DrawingSettings request{
            .placing = {.count = 1500}, .relax = 4, .dot_size = sized ? kByTone : DotSize{}};
        const DrawingPlan plan = pipeline.plan(request);
        std::vector<int> seen;
        std::vector<Dots> dots;
        Stippling drawn;
        REQUIRE(pipeline.draw(plan, drawn, {.stop = {}, .step = [&](const Stippling& now, const auto& copy) {
                                                seen.push_back(now.steps);
                                                dots.push_back(joined(copy()));
                                                return true;
                                            }}));
        CHECK(seen == std::vector<int>{0, 1, 2, 3});
        CHECK(drawn.steps == 4);
        // What was seen is what so many steps and one warp more make of the placed dots.
        DrawingPlan as_placed = plan;
        as_placed.steps = 0;
        CHECK(same(dots.front(), drawn_by(pipeline, as_placed)));
        RankedTile tile = paper_tile();
        Stippling placed;
        REQUIRE(stipple(tile, *plan.density, PlacerKind::exact, plan.placing, placed));
        const RelaxingRequest relaxing = settling(plan, placed.scale, sized);
        stir(placed.dots, *plan.density, relaxing);
        Relaxation relaxation(placed.dots, *plan.density, relaxing);
        std::size_t steps = 0;
        for (const RelaxingStep& how : relaxing_steps(4, relaxing)) {
            REQUIRE(relaxation.step(how));
            if (how.kind == RelaxingStep::Kind::warp || ++steps == dots.size()) continue;
            const Dots warped = joined(relaxation.dots_warped());
            CHECK(dots[steps].x == warped.x);
            CHECK(dots[steps].y == warped.y);
            CHECK(dots[steps].radius.size() == (sized ? warped.size() : 0));
        }
        CHECK(steps == 4);
    }
}

TEST_CASE("whoever watches may end the drawing, with the dots that were seen last") {
    Pipeline pipeline = pipeline_of(ramp());
    for (const bool sized : {false, true}) {
        const DrawingPlan plan =
            pipeline.plan({.placing = {.count = 1500}, .relax = 4, .dot_size = sized ? kByTone : DotSize{}});
        for (const int last : {0, 1, 3}) {
            Dots seen;
            Stippling drawn;
            REQUIRE(
                pipeline.draw(plan, drawn, {.stop = {}, .step = [&](const Stippling& now, const auto& copy) {
                                                seen = joined(copy());
                                                return now.steps < last;
                                            }}));
            CAPTURE(sized);
            CAPTURE(last);
            CHECK(drawn.steps == last);
            CHECK(same(joined(drawn.dots), seen));
        }
    }
}

TEST_CASE("whoever watches sees each pen's dots from the first on, about as many as it will have") {
    Pipeline pipeline = pipeline_of(ramp());
    DrawingSettings settings{.placing = {.count = 3000}, .relax = 3};
    settings.pens = parse_pens("A:#000000,B:#666666,C:#aaaaaa");
    const DrawingPlan plan = pipeline.plan(settings);
    std::vector<DotPieces> seen;
    const auto drawn_until = [&](int last) {
        Stippling drawn;
        REQUIRE(pipeline.draw(plan, drawn, {.stop = {}, .step = [&](const Stippling& now, const auto& copy) {
                                                seen.push_back(copy());
                                                return now.steps < last;
                                            }}));
        return drawn.dots;
    };
    const DotPieces whole = drawn_until(3);
    REQUIRE(seen.size() == 3);
    for (const DotPieces& dots : seen) {
        REQUIRE(dots.pieces.size() == 3);
        for (std::size_t pen = 0; pen < 3; ++pen) {
            CHECK(dots.pieces[pen].pen == int(pen));
            CHECK(double(dots.pieces[pen].size()) ==
                  doctest::Approx(double(whole.pieces[pen].size())).epsilon(0.02));
        }
    }
    const DotPieces ended = drawn_until(1);
    for (std::size_t pen = 0; pen < 3; ++pen) CHECK(same(ended.pieces[pen], seen.back().pieces[pen]));
}

TEST_CASE("a drawing that is stopped says so, and the next one is whole") {
    Pipeline pipeline = pipeline_of(ramp());
    const DrawingPlan plan = pipeline.plan({.placing = {.count = 1500}, .relax = 4});
    const Dots right = drawn_by(pipeline, plan);
    for (const int at : {0, 2}) {
        std::stop_source stop;
        Stippling drawn;
        CHECK_FALSE(pipeline.draw(plan, drawn,
                                  {.stop = stop.get_token(), .step = [&](const Stippling& now, const auto&) {
                                       if (now.steps == at) stop.request_stop();
                                       return true;
                                   }}));
        REQUIRE(pipeline.draw(plan, drawn));
        CHECK(same(joined(drawn.dots), right));
    }
}

TEST_CASE("Figure 8 given a count places about so many different dots") {
    Pipeline pipeline = pipeline_of(ramp());
    const DrawingPlan plan = pipeline.plan({.placer = PlacerKind::figure8, .placing = {.count = 8000}});
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    CHECK(double(drawn.dots.size() - drawn.duplicates) == doctest::Approx(8000).epsilon(0.05));
}
