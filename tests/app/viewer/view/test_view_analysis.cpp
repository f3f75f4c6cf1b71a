// What is measured of the dots on screen, and the thread that does it.

#include <doctest/doctest.h>

#include <cmath>
#include <semaphore>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/view/view_analysis.h"
#include "tests/dot_pieces.h"
#include "tests/point_sets.h"

namespace dapple {
namespace {

const Rectangle<double> kPage{{0, 0}, {1, 1}};

DotPieces dots_of(const std::vector<glm::dvec2>& points) {
    Dots dots;
    for (const glm::dvec2 p : points) {
        dots.x.push_back(static_cast<float>(p.x));
        dots.y.push_back(static_cast<float>(p.y));
    }
    return split(dots);
}

}  // namespace

TEST_CASE("the points in view are those in the rectangle, measured from its corner") {
    const DotPieces dots = dots_of(square_lattice(10));
    const PointsInView view = points_in_view(dots, {{0.2, 0.4}, {0.7, 0.7}});
    CHECK(view.all);
    CHECK(view.domain.width == doctest::Approx(0.5));
    CHECK(view.domain.height == doctest::Approx(0.3));
    CHECK(view.domain.topology == Topology::window);
    REQUIRE(view.points.size() == 15);
    CHECK(view.points.front().x == doctest::Approx(0.03));
    CHECK(view.points.front().y == doctest::Approx(0.07));
    CHECK(points_in_view(dots, {{0.2, 0.4}, {0.1, 0.7}}).points.empty());
}

TEST_CASE("of too many dots those in the middle are measured, as dense as all") {
    const PointsInView view = points_in_view(dots_of(square_lattice(300)), kPage, 10'000);
    CHECK_FALSE(view.all);
    CHECK(view.points.size() <= 10'000);
    CHECK(view.points.size() > 7'500);
    CHECK(static_cast<double>(view.points.size()) / view.domain.area() ==
          doctest::Approx(90'000).epsilon(0.03));
}

TEST_CASE("blocks of dots that lie elsewhere are not looked at, and the points in view are the same") {
    DotPieces dots = dots_of(square_lattice(200));
    const std::vector<DotBlock> blocks = dot_blocks(dots);
    const Rectangle<double> view{{0.3, 0.41}, {0.5, 0.48}};
    const std::vector<glm::dvec2> expected = points_in_view(dots, view).points;
    CHECK(expected.size() > 500);
    // Dots that would be in view if anybody looked at them.
    std::size_t moved = 0;
    for (const DotBlock& block : blocks) {
        if (block.low.y <= 0.48f && block.high.y >= 0.41f) continue;
        for (std::size_t i = 0; i < block.count; ++i, ++moved)
            dots.pieces[block.piece].y[block.first + i] = 0.45f;
    }
    CHECK(moved > 20'000);
    CHECK(points_in_view(dots, view, kMostAnalysed, blocks).points == expected);
}

TEST_CASE("all dots in one place do not keep the view shrinking for ever") {
    Dots dots;
    dots.x.assign(1000, 0.25f);
    dots.y.assign(1000, 0.25f);
    CHECK(points_in_view(in_one_piece(dots), kPage, 100).points.size() <= 100);
}

TEST_CASE("a square lattice repeats itself and keeps its known distance") {
    const auto analysis = analyse_view({.view = points_in_view(dots_of(square_lattice(64)), kPage)});
    REQUIRE(analysis);
    CHECK(analysis->dots == 4096);
    REQUIRE(analysis->periodicity);
    CHECK(analysis->periodicity->value == doctest::Approx(1));
    const double square = std::sqrt(std::sqrt(3) / 2);
    CHECK(analysis->nearest.minimum == doctest::Approx(square).epsilon(1e-4));
    CHECK(analysis->nearest.mean == doctest::Approx(square).epsilon(1e-4));
    CHECK(analysis->peaks.highest_bin == doctest::Approx(4096).epsilon(1e-3));
    CHECK(analysis->low_frequency_power == doctest::Approx(0).epsilon(1e-3));
    CHECK_FALSE(analysis->picture.empty());
}

TEST_CASE("dots thrown at random do not repeat and have power 1 everywhere") {
    const auto analysis = analyse_view({.view = points_in_view(dots_of(white_noise(8000, 7)), kPage)});
    REQUIRE(analysis);
    REQUIRE(analysis->periodicity);
    CHECK(analysis->periodicity->value < 0.05);
    CHECK(analysis->low_frequency_power == doctest::Approx(1).epsilon(0.1));
    CHECK(analysis->nearest.mean == doctest::Approx(0.4653).epsilon(0.03));
}

TEST_CASE("a dot that is there twice counts once") {
    DotPieces dots = dots_of(square_lattice(32));
    dots.pieces.push_back(joined(dots));
    const auto analysis = analyse_view({.view = points_in_view(dots, kPage), .has_duplicates = true});
    REQUIRE(analysis);
    CHECK(analysis->dots == 1024);
    CHECK(analysis->nearest.minimum == doctest::Approx(std::sqrt(std::sqrt(3) / 2)).epsilon(1e-4));
}

TEST_CASE("a view of less than two tiles has no periodicity") {
    const auto analysis =
        analyse_view({.view = points_in_view(dots_of(square_lattice(10)), kPage), .tile_size = 64});
    REQUIRE(analysis);
    CHECK_FALSE(analysis->periodicity);
}

TEST_CASE("an empty view is measured without an error") {
    const auto analysis = analyse_view({});
    REQUIRE(analysis);
    CHECK(analysis->dots == 0);
    CHECK(analysis->error.empty());
}

TEST_CASE("work in the background wakes the window with a result, and is free again") {
    std::binary_semaphore woken(0);
    Background<ViewAnalysis> analyst([&] { woken.release(); });
    for (const int m : {20, 30}) {
        analyst.begin(analysis_work({.view = points_in_view(dots_of(square_lattice(m)), kPage)}));
        woken.acquire();
        CHECK_FALSE(analyst.busy());
        const auto result = analyst.result();
        REQUIRE(result);
        CHECK(result->dots == static_cast<std::size_t>(m * m));
        CHECK_FALSE(analyst.result());
    }
}

TEST_CASE("work in the background that is told to stop wakes the window without a wrong result") {
    std::binary_semaphore woken(0);
    Background<ViewAnalysis> analyst([&] { woken.release(); });
    analyst.begin(analysis_work({.view = points_in_view(dots_of(white_noise(20'000, 7)), kPage)}));
    analyst.stop();
    woken.acquire();
    CHECK_FALSE(analyst.busy());
    if (const auto result = analyst.result()) CHECK(result->dots == 20'000);
}

}  // namespace dapple
