// What is drawn while there is no time for all dots.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "app/viewer/background/preview_dots.h"
#include "app/viewer/background/workbench.h"
#include "core/analysis/distances.h"
#include "core/output/raster.h"

namespace dapple {
namespace {

PlacedDrawing placed(std::uint64_t count, int steps, bool thresholds, bool in_part = true,
                     PlacerKind placer = PlacerKind::exact, DensitySource density = DensitySource::grey) {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(8, 8, 0.5f)});
    DotsRequest request;
    request.drawing.tile = kDefaultTile;
    request.density.source = density;
    request.drawing.placing = {.count = count, .threads = 1, .thresholds = thresholds};
    request.drawing.relax = steps;
    request.in_part = in_part;
    request.drawing.placer = placer;
    if (placer == PlacerKind::figure8) request.drawing.tile = "paper16";
    PlacedDrawing drawing;
    bench.place(request, drawing);
    return drawing;
}

/// Mean distance to the nearest dot, over that of a hexagonal lattice.
double evenness(std::vector<glm::dvec2> points) {
    for (glm::dvec2& p : points) p = glm::clamp(p, glm::dvec2(0), glm::dvec2(1 - 1e-9));
    return nearest_summary(points, {1, 1, Topology::window}).mean;
}

PreviewDots preview_of(const PlacedDrawing& drawing, double every) {
    const std::vector<DotBlock> blocks = dot_blocks(drawing.dots);
    std::vector<std::size_t> all(blocks.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const double radius = drawing.dot_radius();
    return preview_dots({.dots = drawing.dots,
                         .blocks = blocks,
                         .in_view = all,
                         .view = {{0, 0}, {1, 1}},
                         .radius = radius,
                         .ink = drawing.ink,
                         .full_load = std::numbers::pi * radius * radius * kDotsPerScale * drawing.scale},
                        every);
}

}  // namespace

TEST_CASE("the dots that are previewed of too many are far more even than some at random, relaxed or not") {
    for (const int steps : {0, 3}) {
        CAPTURE(steps);
        const PlacedDrawing drawing = placed(20'000, steps, true);
        for (const double every : {3.0, 8.0, 20.0}) {
            CAPTURE(every);
            std::vector<glm::dvec2> drawn, all;
            for_each_position(drawing.dots, [&](float x, float y) { all.emplace_back(x, y); });
            for_each_position(preview_of(drawing, every).dots,
                              [&](float x, float y) { drawn.emplace_back(x, y); });
            CHECK(static_cast<double>(drawn.size()) * every == doctest::Approx(20'000).epsilon(0.02));
            std::shuffle(all.begin(), all.end(), std::mt19937(1));
            all.resize(drawn.size());
            CHECK(evenness(drawn) > 0.65);
            CHECK(evenness(drawn) > 1.15 * evenness(all));
        }
    }
}

TEST_CASE("a preview is as light as all dots, in light, middle and dark tones, relaxed or not") {
    for (const int steps : {0, 10}) {
        const PlacedDrawing drawing =
            placed(50'000, steps, true, true, PlacerKind::exact, DensitySource::ramp);
        const glm::dvec2 size = drawing.plan.picture_size();
        const PageSize page{size.x, size.y, 1};
        const auto light = [&](const DotPieces& dots) {
            return coverage_of({.size = page, .dots = stream_of(dots), .dot_radius_mm = drawing.dot_radius()},
                               {.dpi = 25.4 * 1500, .threads = 0});
        };
        const Grid<float> all = light(drawing.dots);
        for (const double every : {2.0, 3.0, 6.0, 15.0}) {
            const Grid<float> some = light(preview_of(drawing, every).dots);
            for (int third = 0; third < 3; ++third) {
                CAPTURE(steps);
                CAPTURE(every);
                CAPTURE(third);
                double apart = 0;
                for (int y = 0; y < all.height; ++y)
                    for (int x = third * all.width / 3; x < (third + 1) * all.width / 3; ++x)
                        apart += some.at(x, y) - all.at(x, y);
                CHECK(std::abs(apart * 3 / all.width / all.height) < (steps == 0 ? 0.008 : 0.015));
            }
        }
    }
}

TEST_CASE(
    "dots on the screen say when they appear, however few and whoever places them, in a file they need not") {
    const auto says = [](const PlacedDrawing& drawing) {
        return std::ranges::all_of(drawing.dots.pieces,
                                   [](const Dots& piece) { return piece.critical.size() == piece.size(); });
    };
    CHECK(says(placed(100'000, 0, false)));
    CHECK(says(placed(5'000, 3, false)));
    CHECK_FALSE(says(placed(5'000, 0, false, false)));
    CHECK(says(placed(5'000, 0, false, true, PlacerKind::figure8)));
}

TEST_CASE("no dots have no preview") {
    CHECK(preview_dots({.dots = DotPieces{}}, 3).blocks.empty());
}

}  // namespace dapple
