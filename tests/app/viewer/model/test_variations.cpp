// Variations of a drawing.

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <stop_token>
#include <string>

#include "app/viewer/background/small_pictures.h"
#include "app/viewer/model/variations.h"

namespace dapple {
namespace {

/// Of a ramp from dark to light.
double mean_light(const DrawingSettings& drawing) {
    SmallPicture ramp(64, 48);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) ramp.row(y)[x] = glm::u8vec4(4 * x, 4 * x, 4 * x, 255);
    const SmallPicture drawn = small_drawing(ramp, drawing, 200, std::stop_token());
    double sum = 0;
    for (const glm::u8vec4 pixel : drawn.values) sum += pixel.g;
    return sum / static_cast<double>(drawn.values.size());
}

const DrawingSettings& named(const std::array<Variation, 9>& all, const std::string& name) {
    for (const Variation& each : all)
        if (each.name == name) return each.drawing;
    CAPTURE(name);
    FAIL("no variation is called so");
    return all[0].drawing;
}

}  // namespace

TEST_CASE("nine variations all differ, and the middle one is the drawing as it is") {
    DrawingSettings now;
    const DrawnInfo drawn{.dots = 40'000, .scale = 2000, .dot_radius_mm = 0.2};
    for (const DotSizing sizing : {DotSizing::automatic, DotSizing::by_tone}) {
        now.dot_size.sizing = sizing;
        const auto all = variations_of(now, drawn);
        CHECK(all[4].drawing == now);
        std::set<std::string> names;
        for (std::size_t i = 0; i < all.size(); ++i) {
            names.insert(all[i].name);
            CHECK((i == 4 || all[i].drawing != now));
        }
        CHECK(names.size() == all.size());
    }
}

TEST_CASE("the lighter and the darker variation are so on paper, and have what was chosen automatically") {
    DrawingSettings now;
    now.placing.count = 2000;
    const DrawnInfo drawn{
        .dots = 2000, .scale = 100, .dot_radius_mm = 0.2, .tone = {.gamma = 1.3f, .detail = 0.5f}};
    const auto all = variations_of(now, drawn);
    CHECK(named(all, "lighter").tone.gamma == 1.3f);
    const double lighter = mean_light(named(all, "lighter")), darker = mean_light(named(all, "darker"));
    CHECK(lighter > darker + 10);
}

TEST_CASE("more and fewer dots are twice and half as many, by whatever they are counted") {
    DrawingSettings now;
    const DrawnInfo drawn{.dots = 40'000, .scale = 2000, .dot_radius_mm = 0.2, .most_dots = 60'000};
    auto all = variations_of(now, drawn);
    CHECK(named(all, "more dots").placing.count == 60'000);  // no more than there is memory for
    CHECK(named(all, "fewer dots").placing.count == 20'000);
    now.placing.count.reset();
    now.placing.scale = 2000;
    all = variations_of(now, drawn);
    CHECK(named(all, "more dots").placing.scale == 4000);
    now.dot_size = dot_size_from(DotSizing::by_tone, 0.2);
    all = variations_of(now, drawn);
    // Half the area each.
    CHECK(named(all, "more dots").dot_size.largest_mm ==
          doctest::Approx(now.dot_size.largest_mm / 1.4142).epsilon(1e-3));
    CHECK(named(all, "one size").dot_size.sizing == DotSizing::automatic);
}

}  // namespace dapple
