// What is drawn while there is no time for all dots.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "app/viewer/background/even_part.h"
#include "app/viewer/background/workbench.h"
#include "core/analysis/distances.h"

namespace dapple {
namespace {

PlacedDrawing placed(std::uint64_t count, int steps, bool thresholds, bool in_part = true,
                     PlacerKind placer = PlacerKind::exact) {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(8, 8, 0.5f)});
    DotsRequest request;
    request.tile = kDefaultTile;
    request.density.source = DensitySource::grey;
    request.drawing.placing.count = count;
    request.drawing.placing.thresholds = thresholds;
    request.drawing.relax = steps;
    request.in_part = in_part;
    request.drawing.placer = placer;
    if (placer == PlacerKind::figure8) request.tile = "paper16";
    PlacedDrawing drawing;
    bench.place(request, drawing);
    return drawing;
}

/// Mean distance to the nearest dot, over that of a hexagonal lattice.
double evenness(std::vector<glm::dvec2> points) {
    for (glm::dvec2& p : points) p = glm::clamp(p, glm::dvec2(0), glm::dvec2(1 - 1e-9));
    return nearest_summary(points, {1, 1, Topology::window}).mean;
}

}  // namespace

TEST_CASE("the part that is drawn of too many dots is far more even than one at random, relaxed or not") {
    for (const int steps : {0, 3}) {
        CAPTURE(steps);
        const PlacedDrawing drawing = placed(20'000, steps, true);
        const DotPieces& dots = drawing.dots;
        const EvenPart part(dots);
        REQUIRE(part.is_known());
        for (const double every : {3.0, 8.0, 20.0}) {
            CAPTURE(every);
            std::vector<glm::dvec2> drawn, all;
            for (const Dots& piece : dots.pieces) {
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    all.emplace_back(piece.x[i], piece.y[i]);
                    if (piece.critical[i] <= part.limit(every)) drawn.push_back(all.back());
                }
            }
            CHECK(static_cast<double>(drawn.size()) * every == doctest::Approx(20'000).epsilon(0.02));
            std::shuffle(all.begin(), all.end(), std::mt19937(1));
            all.resize(drawn.size());
            CHECK(evenness(drawn) > 0.65);
            CHECK(evenness(drawn) > 1.15 * evenness(all));
        }
    }
}

TEST_CASE(
    "dots on the screen say when they appear, however few and whoever places them, in a file they need not") {
    const auto says = [](const PlacedDrawing& drawing) { return EvenPart(drawing.dots).is_known(); };
    constexpr std::size_t kLarge = 100'000;
    const PlacedDrawing large = placed(kLarge, 0, false);
    CHECK(says(large));
    const float limit = EvenPart(large.dots).limit(10);
    std::size_t drawn = 0;
    for (const Dots& piece : large.dots.pieces)
        drawn += static_cast<std::size_t>(
            std::ranges::count_if(piece.critical, [limit](float critical) { return critical <= limit; }));
    CHECK(static_cast<double>(drawn) == doctest::Approx(kLarge / 10.0).epsilon(0.05));
    CHECK(says(placed(5'000, 3, false)));
    CHECK_FALSE(says(placed(5'000, 0, false, false)));
    CHECK(says(placed(5'000, 0, false, true, PlacerKind::figure8)));
}

TEST_CASE("of no dots there is no part") {
    CHECK_FALSE(EvenPart(DotPieces{}).is_known());
}

}  // namespace dapple
