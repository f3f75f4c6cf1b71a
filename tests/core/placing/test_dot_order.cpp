#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/placing/dot_order.h"
#include "core/placing/placer.h"
#include "core/tile/ranking.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

Dots some_dots() {
    const Tile tile = make_tile(14217, 2895, 16);
    Placer placer(make_placing_table(tile, rank(tile, RankingMethod::energy)));
    Grid<float> ramp(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) ramp.at(x, y) = static_cast<float>(x) / 64;
    }
    DotPieces dots;
    placer.place(Density(ramp), {.scale = 1000, .thresholds = true}, dots);
    return joined(dots);
}

std::multiset<std::pair<float, float>> places(const Dots& dots, std::size_t count) {
    std::multiset<std::pair<float, float>> result;
    for (std::size_t i = 0; i < count; ++i) result.emplace(dots.x[i], dots.y[i]);
    return result;
}

double path_length(const Dots& dots) {
    double length = 0;
    for (std::size_t i = 1; i < dots.size(); ++i) {
        length += std::hypot(dots.x[i] - dots.x[i - 1], dots.y[i] - dots.y[i - 1]);
    }
    return length;
}

}  // namespace

TEST_CASE("by priority, the first dots are the lighter drawing") {
    Dots dots = some_dots();
    const auto all = places(dots, dots.size());
    sort_dots(dots, DotOrder::priority);
    CHECK(places(dots, dots.size()) == all);
    CHECK(std::is_sorted(dots.critical.begin(), dots.critical.end()));
}

TEST_CASE("by space, a pen's way is a small multiple of what dots of that number need") {
    Dots dots = some_dots();
    const auto all = places(dots, dots.size());
    const double as_placed = path_length(dots);
    sort_dots(dots, DotOrder::space);
    CHECK(places(dots, dots.size()) == all);
    // No tour is shorter than about 0.7 sqrt(n * area), and a Hilbert curve's is a third longer than the
    // shortest.
    const double scale = std::sqrt(static_cast<double>(dots.size()));
    CHECK(path_length(dots) < 1.3 * scale);
    CHECK(path_length(dots) < 0.5 * as_placed);
}

TEST_CASE(
    "a pen's way is as long where the drawing lies elsewhere or is larger: margins and sheets change "
    "nothing") {
    Dots dots = some_dots(), moved = dots;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        moved.x[i] = 3 * moved.x[i] + 0.7f;
        moved.y[i] = 3 * moved.y[i] - 1.4f;
    }
    sort_dots(dots, DotOrder::space);
    sort_dots(moved, DotOrder::space);
    CHECK(path_length(moved) == doctest::Approx(3 * path_length(dots)).epsilon(0.01));
}
