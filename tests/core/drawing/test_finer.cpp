// Where a mask makes dots finer: how many there are, how large each is, and how light both halves of a page
// are once they are drawn.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/image/tone.h"
#include "core/placing/page.h"
#include "core/tile/tile_file.h"
#include "tests/dot_pieces.h"
#include "tests/drawn_pixels.h"
#include "tests/mean_light.h"

using namespace dapple;

namespace {

constexpr int kWidth = 128, kHeight = 64;
const DotSize kByTone{.sizing = DotSizing::by_tone, .smallest_mm = 0.35, .largest_mm = 0.7};

// Finer on the right half.
Mask half_finer(std::uint8_t fineness) {
    Grid<std::uint8_t> fine(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = kWidth / 2; x < kWidth; ++x) fine.at(x, y) = fineness;
    return Mask(Grid<std::uint8_t>(kWidth, kHeight, kNeutralLevel), std::move(fine));
}

Pipeline pipeline_of(Grid<float> light) {
    Pipeline pipeline;
    pipeline.set_tile(ranked_tile(*built_in_tile(kDefaultTile)));
    pipeline.set_light(std::move(light));
    return pipeline;
}

struct Half {
    double dots = 0, light = 0, radius = 0;  // the mean radius, page units
};
struct Halves {
    std::uint64_t dots = 0;
    Half left, right;  // off the page's edges and the line between them
};

Halves drawn_halves(Pipeline& pipeline, const DrawingSettings& settings) {
    const DrawingPlan plan = pipeline.plan(settings);
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    const Grid<glm::u8vec3> pixels = drawn_pixels(settings, plan, drawn, 1600);
    Halves halves{drawn.dots.size(), {}, {}};
    for (Half* const half : {&halves.left, &halves.right}) {
        const double left = half == &halves.left ? 0.04 : 0.54;
        const glm::dvec2 low(left, 0.04), high(left + 0.42, 0.46);
        for (const Dots& piece : drawn.dots.pieces) {
            for (std::size_t i = 0; i < piece.size(); ++i) {
                if (piece.x[i] < low.x || piece.x[i] >= high.x || piece.y[i] < low.y || piece.y[i] >= high.y)
                    continue;
                ++half->dots;
                half->radius += piece.radius.empty() ? plan.radius(drawn.scale) : double(piece.radius[i]);
            }
        }
        half->radius /= std::max(half->dots, 1.0);
        half->light = mean_light(pixels, {low * 1600.0, high * 1600.0}).y;
    }
    return halves;
}

bool same(const Dots& a, const Dots& b) {
    return a.x == b.x && a.y == b.y && a.radius == b.radius && a.pen == b.pen;
}

}  // namespace

TEST_CASE("so many times as many dots of as much less area keep the tone, as placed and as settled") {
    struct Way {
        const char* name;
        DotSize size;
        PenChoice pens;
    };
    const std::vector<Way> ways{{"automatic", {}, {}},
                                {"fixed", {.sizing = DotSizing::fixed, .radius_mm = 0.6}, {}},
                                {"by tone", kByTone, {}},
                                {"pens", {}, {.set = PenSet::greys}}};
    const float light = srgb_to_linear(0.5f);
    Pipeline pipeline = pipeline_of(Grid<float>(kWidth, kHeight, light));
    ColourGrid colours(kWidth, kHeight);
    std::ranges::fill(colours.values, packed(glm::vec3(light)));
    pipeline.set_colours(std::move(colours));
    for (const Way& way : ways) {
        CAPTURE(std::string(way.name));
        for (const int fineness : {170, 255}) {
            const double times = 1 + fineness / 85.0;
            CAPTURE(times);
            for (const int steps : {0, 8}) {
                CAPTURE(steps);
                DrawingSettings request{.automatic_tone = false,
                                        .mask = half_finer(static_cast<std::uint8_t>(fineness)),
                                        .placing = {.count = 12'000},
                                        .relax = steps,
                                        .dot_size = way.size,
                                        .pens = way.pens};
                const Halves halves = drawn_halves(pipeline, request);
                if (way.size.sizing != DotSizing::by_tone) CHECK(halves.dots == 12'000);
                CHECK(halves.right.dots / halves.left.dots == doctest::Approx(times).epsilon(0.02));
                CHECK(std::pow(halves.left.radius / halves.right.radius, 2) ==
                      doctest::Approx(times).epsilon(1e-4));
                // How much dots cover that hardly moved depends on where their number lies between two levels
                // of the tile: four times as many are a whole level more.
                if (steps > 0 || times == 4) CHECK(std::abs(halves.right.light - halves.left.light) < 0.01);
            }
        }
    }
}

TEST_CASE("a part of a page, in any number of threads, has the finer dots of the whole to the bit") {
    Grid<float> ramp(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) ramp.at(x, y) = static_cast<float>(y) / kHeight;
    Pipeline pipeline = pipeline_of(std::move(ramp));
    PageSetup turned;
    turned.crop = parse_crop("10,6,90x50");
    turned.quarter_turns = 1;
    for (const DotSize& size : {DotSize{}, kByTone}) {
        for (const int steps : {0, 6}) {
            CAPTURE(steps);
            DrawingSettings request{.mask = half_finer(200),
                                    .placing = {.count = 4000, .threads = 1},
                                    .relax = steps,
                                    .dot_size = size,
                                    .page = turned};
            const DrawingPlan plan = pipeline.plan(request);
            const Dots whole = all_of(pipeline.stream(plan));
            REQUIRE(whole.radius.size() == whole.size());
            Stippling drawn;
            REQUIRE(pipeline.draw(plan, drawn));
            CHECK(same(joined(drawn.dots), whole));
            const PagePart part{{0.2f, 0.4f, 0.2}, {0.3f, 0.8f, 0.3}};
            Dots cut = whole;
            cut_to(part, cut);
            REQUIRE(cut.size() > 50);
            CHECK(same(all_of(pipeline.stream(plan, part)), cut));
            request.placing.threads = 3;
            CHECK(same(all_of(pipeline.stream(pipeline.plan(request), part)), cut));
        }
    }
}

TEST_CASE("dots are finer where the mask is, wherever crop and turns put it") {
    // The picture's right half is the upper one once it is turned by three quarters; of that, the crop leaves
    // a quarter of the height.
    Pipeline pipeline = pipeline_of(Grid<float>(kWidth, kHeight, 0.5f));
    DrawingSettings request{.mask = half_finer(255), .placing = {.count = 3000}, .relax = 0};
    request.page.crop = parse_crop("25%,0,33.334%x100%");
    request.page.quarter_turns = 3;
    Stippling drawn;
    const DrawingPlan plan = pipeline.plan(request);
    REQUIRE(pipeline.draw(plan, drawn));
    const Dots dots = joined(drawn.dots);
    const double pixels = std::max(plan.pixels.x, plan.pixels.y), edge = 11 / pixels;
    REQUIRE(plan.pixels == glm::ivec2(64, 43));
    for (std::size_t i = 0; i < dots.size(); ++i) {
        if (std::abs(dots.y[i] - edge) < 1 / pixels) continue;  // between two pixels of the mask
        const double share = dots.radius[i] / plan.radius(drawn.scale);
        REQUIRE(share == doctest::Approx(dots.y[i] < edge ? 0.5 : 1));
    }
}

TEST_CASE("lines, and dots as wide as their pen, are drawn as if nothing was finer") {
    Pipeline pipeline = pipeline_of(Grid<float>(kWidth, kHeight, 0.5f));
    const DrawingSettings plain{.placing = {.count = 500}, .relax = 0};
    std::vector<DrawingSettings> requests(4, plain);
    requests[0].style = DrawingStyle::line;
    requests[1].style = DrawingStyle::nearest;
    requests[2].mark = {DotShape::point};
    requests[3].pens = {.set = PenSet::cmyk, .width_mm = 0.4};
    for (DrawingSettings& request : requests) {
        CHECK_FALSE(can_be_finer(request));
        const Dots before = all_of(pipeline.stream(pipeline.plan(request)));
        request.mask = half_finer(255);
        CHECK_FALSE(has_several_sizes(request));
        CHECK(same(all_of(pipeline.stream(pipeline.plan(request))), before));
    }
    // Where sizes go by tone the pen's width has no say, nor where it draws a shape's lines.
    requests[3].dot_size = kByTone;
    CHECK(has_several_sizes(requests[3]));
    requests[3].dot_size = {};
    requests[3].mark = {DotShape::spiral};
    CHECK(has_several_sizes(requests[3]));
}

TEST_CASE("where all of a picture is finer, the radius that is told and the usual margin are its dots'") {
    Pipeline pipeline = pipeline_of(Grid<float>(kWidth, kHeight, 0.5f));
    DrawingSettings request{.placing = {.count = 2000}, .relax = 0};
    request.mask = Mask(Grid<std::uint8_t>(kWidth, kHeight, kNeutralLevel),
                        Grid<std::uint8_t>(kWidth, kHeight, std::uint8_t{255}));
    for (const DotSize& size : {DotSize(), DotSize{.sizing = DotSizing::fixed, .radius_mm = 0.6}, kByTone}) {
        request.dot_size = size;
        const DrawingPlan plan = pipeline.plan(request);
        Stippling drawn;
        REQUIRE(pipeline.draw(plan, drawn));
        const Dots dots = joined(drawn.dots);
        const PageLayout layout = plan.layout(drawn.scale);
        const double largest = std::ranges::max(dots.radius) * layout.page.mm_per_page_unit;
        if (size.sizing == DotSizing::fixed) CHECK(largest == doctest::Approx(0.3));
        if (size.sizing != DotSizing::by_tone) CHECK(plan.radius_mm(drawn.scale) == doctest::Approx(largest));
        if (size.sizing == DotSizing::by_tone) CHECK(plan.radius_mm(drawn.scale) == doctest::Approx(0.35));
        CHECK(layout.reach_mm == doctest::Approx(plan.radius_mm(drawn.scale)));
    }
}
