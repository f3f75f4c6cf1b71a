// Which tiles the loupe lays on one another, and which dots of them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/view/loupe_square.h"
#include "tests/dot_pieces.h"
#include "tests/point_sets.h"

namespace dapple {
namespace {

/// m x m dots in even rows, on the whole page or in a window.
PlacedDrawing lattice(int m, const PageWindow& window = {}) {
    PlacedDrawing drawing;
    drawing.plan.placing.window = window;
    Dots dots;
    for (const glm::dvec2 p : square_lattice(m)) {
        dots.x.push_back(static_cast<float>(p.x * window.width));
        dots.y.push_back(static_cast<float>(p.y * window.height));
    }
    drawing.dots = split(dots);
    return drawing;
}

PagePoint end_of(const LoupeSquare& square) {
    return square.corner + (std::int64_t(1) << (62 - square.level)) * square.across;
}

bool on_the_grid(const LoupeSquare& square) {
    const std::int64_t side = std::int64_t(1) << (62 - square.level);
    return square.corner.x % side == 0 && square.corner.y % side == 0;
}

}  // namespace

TEST_CASE("the loupe takes the deepest level that the dots have gone through, around the pointer") {
    // 256 x 256 dots are 64 x 64 tiles of 16.
    const auto square = loupe_square(lattice(256), 16, page_point({0.4, 0.7}), 0);
    REQUIRE(square);
    CHECK(square->level == 6);
    CHECK(square->period() == 1.0 / 64);
    CHECK(square->across == 8);
    CHECK(on_the_grid(*square));
    const glm::dvec2 middle = in_page_units((square->corner + end_of(*square)) / std::int64_t(2));
    CHECK(std::abs(middle.x - 0.4) <= 0.5 / 64);
    CHECK(std::abs(middle.y - 0.7) <= 0.5 / 64);
}

TEST_CASE("a large tile is looked at in parts small enough to lay some dozens of them on one another") {
    // One tile of 4096 fills a quarter of the page, and no two of its eighths need be alike.
    const auto square = loupe_square(lattice(128), 4096, page_point({0.5, 0.5}), 0);
    REQUIRE(square);
    CHECK(square->level >= 3);
    CHECK(square->across * square->across >= 24);
}

TEST_CASE("a step goes one level deeper, or back") {
    const PlacedDrawing drawing = lattice(256);
    for (const int step : {-1, 1, 2}) {
        const auto square = loupe_square(drawing, 16, page_point({0.5, 0.5}), step);
        REQUIRE(square);
        CHECK(square->level == 6 + step);
        CHECK(on_the_grid(*square));
    }
}

TEST_CASE("at the page's edge the loupe's square stays within the page") {
    PlacedDrawing upright = lattice(256);
    upright.plan.pixels = {60, 100};
    for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(0.599, 0.999), glm::dvec2(0.599, 0.3)}) {
        const auto square = loupe_square(upright, 16, page_point(p), 0);
        REQUIRE(square);
        const glm::dvec2 low = in_page_units(square->corner), high = in_page_units(end_of(*square));
        CHECK(low.x >= 0);
        CHECK(low.y >= 0);
        CHECK(high.x <= 0.6);
        CHECK(high.y <= 1);
        CHECK(on_the_grid(*square));
    }
}

TEST_CASE("deep in the page the loupe's square lies within the dots that are there, on the page's grid") {
    // A window 2^-30 wide whose corner lies on no tile's.
    const std::int64_t corner = (std::int64_t(1) << 61) + (std::int64_t(1) << 32) / 3;
    const PageWindow window{corner, corner, 0x1p-30, 0x1p-30};
    const PagePoint middle = PagePoint(corner) + (std::int64_t(1) << 31);
    const PlacedDrawing drawing = lattice(256, window);
    const auto square = loupe_square(drawing, 16, middle, 0);
    REQUIRE(square);
    CHECK(square->level == 36);
    CHECK(on_the_grid(*square));
    CHECK(square->corner.x >= corner);
    CHECK(end_of(*square).x <= corner + (std::int64_t(1) << 32));
    CHECK(square->corner.x < middle.x);
    CHECK(end_of(*square).x > middle.x);
    // 4 x 4 dots in each of 8 x 8 tiles.
    CHECK(folded(drawing, *square).points.size() == 16 * 64);
}

TEST_CASE("beside the page and where there are hardly any dots there is nothing to fold") {
    const PlacedDrawing drawing = lattice(256);
    for (const glm::dvec2 p : {glm::dvec2(-0.01, 0.5), glm::dvec2(0.5, -0.01), glm::dvec2(1.01, 0.5)})
        CHECK_FALSE(loupe_square(drawing, 16, page_point(p), 0));
    CHECK_FALSE(loupe_square(PlacedDrawing{}, 16, page_point({0.5, 0.5}), 0));
    CHECK_FALSE(loupe_square(lattice(2), 16, page_point({0.5, 0.5}), 0));
    // Tiles so large that no two of them lie side by side.
    CHECK_FALSE(loupe_square(drawing, 16, page_point({0.5, 0.5}), -6));
}

TEST_CASE("the loupe folds the square's own dots, each in its place within its tile") {
    const PlacedDrawing drawing = lattice(256);
    const auto square = loupe_square(drawing, 16, page_point({0.3, 0.6}), 0);
    REQUIRE(square);
    const Folding folding = folded(drawing, *square);
    CHECK(folding.layers == 64);
    REQUIRE(folding.points.size() == 16 * 64);
    // A tile has 4 x 4 dots, a quarter apart; the lattice begins 0.3 spacings from the left, 0.7 from above.
    double furthest = 0;
    for (const glm::dvec2 p : folding.points)
        furthest = std::max({furthest, std::abs(std::remainder(4 * p.x - 0.3, 1)),
                             std::abs(std::remainder(4 * p.y - 0.7, 1))});
    CHECK(furthest < 1e-3);
    CHECK(repetition(folding) == doctest::Approx(1));
}

TEST_CASE("dots that lie on one another, as Figure 8 emits them, are folded once") {
    PlacedDrawing drawing = lattice(256);
    DotPieces& dots = drawing.dots;
    drawing.duplicates = dots.size();
    dots.pieces.push_back(joined(dots));
    const LoupeSquare square{page_point({0.25, 0.25}), 6, 8};
    CHECK(folded(drawing, square).points.size() == 16 * 64);
}

}  // namespace dapple
