// How light an even grey is that several pens draw whose dots differ in size.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/tile/tile_file.h"
#include "tests/drawn_pixels.h"
#include "tests/mean_light.h"

using namespace dapple;

namespace {

constexpr int kSide = 64, kDrawnSide = 1000;

// Off the page's edges.
double light_drawn(float light, DrawingSettings settings) {
    Pipeline pipeline;
    pipeline.set_tile(ranked_tile(*built_in_tile(kDefaultTile)));
    pipeline.set_light(Grid<float>(kSide, kSide, light));
    ColourGrid colours(kSide, kSide);
    std::ranges::fill(colours.values, packed(glm::vec3(light)));
    pipeline.set_colours(std::move(colours));
    settings.automatic_tone = false;
    settings.placing.count = 4000;
    if (settings.dot_size.sizing != DotSizing::by_tone)
        settings.placing.count = static_cast<std::uint64_t>(pipeline.plan(settings).dots_for_tone());
    const DrawingPlan plan = pipeline.plan(settings);
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    const Grid<glm::u8vec3> pixels = drawn_pixels(settings, plan, drawn, kDrawnSide);
    return mean_light(pixels, {glm::dvec2(0.08 * kDrawnSide), glm::dvec2(0.92 * kDrawnSide)}).y;
}

}  // namespace

TEST_CASE("pens keep the tone, whether their dots are of several sizes or go by tone") {
    struct Way {
        const char* name;
        const char* pens;
        DotSize size;
    };
    const DotSize by_tone{.sizing = DotSizing::by_tone, .smallest_mm = 0.7, .largest_mm = 2};
    const std::vector<Way> ways{{"two widths", "A:#000000:3,B:#010101:1.5", {}},
                                {"three widths, greys", "A:#000000:1.5,B:#555555:3,C:#999999:2", {}},
                                {"by tone", "A:#000000,B:#010101", by_tone},
                                {"by tone, whatever the widths", "A:#000000:3,B:#010101:1.5", by_tone}};
    for (const Way& way : ways) {
        CAPTURE(std::string(way.name));
        for (const float light : {0.1f, 0.3f}) {
            CAPTURE(light);
            DrawingSettings settings;
            settings.pens = parse_pens(way.pens);
            settings.dot_size = way.size;
            CHECK(std::abs(light_drawn(light, settings) - light) < 0.02);
        }
    }
}
