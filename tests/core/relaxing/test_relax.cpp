// Relaxation against a slow reference in double precision, and what has to hold of any relaxed drawing.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "core/analysis/distances.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

RankedTile& test_tile() {
    static RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    return tile;
}

Grid<float> picture_of(int width, int height, const std::function<double(int, int)>& value) {
    Grid<float> grid(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) grid.at(x, y) = static_cast<float>(value(x, y));
    return grid;
}

Stippling placed(const Density& density, std::uint64_t count, bool thresholds = false) {
    Stippling result;
    REQUIRE(
        stipple(test_tile(), density, PlacerKind::exact, {.count = count, .thresholds = thresholds}, result));
    return result;
}

Dots relaxed(const Density& density, const Stippling& from, int steps, int threads = 1) {
    DotPieces dots = from.dots;
    REQUIRE(relax(dots, density, steps, {.scale = from.scale, .threads = threads}));
    return joined(dots);
}

// A step alone.
Dots stepped(const Density& density, const Stippling& from) {
    Relaxation relaxation(from.dots, density, {.scale = from.scale});
    REQUIRE(relaxation.step());
    return joined(relaxation.dots());
}

std::vector<glm::dvec2> positions(const Dots& dots) {
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < dots.size(); ++i) result.emplace_back(dots.x[i], dots.y[i]);
    return result;
}

// Numbers the dots in their radii, so that each is known again.
Stippling numbered(Stippling from) {
    float number = 0;
    for (Dots& piece : from.dots.pieces) {
        piece.radius.resize(piece.size());
        for (float& radius : piece.radius) radius = number++;
    }
    return from;
}

// The dots' places by their numbers.
std::vector<glm::dvec2> by_number(const Dots& dots) {
    std::vector<glm::dvec2> result(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i)
        result[static_cast<std::size_t>(dots.radius[i])] = {dots.x[i], dots.y[i]};
    return result;
}

bool same(const Dots& a, const Dots& b) {
    return a.x == b.x && a.y == b.y && a.threshold == b.threshold && a.critical == b.critical &&
           a.radius == b.radius;
}

Grid<float> soft_picture(int width, int height) {
    return picture_of(width, height, [&](int x, int y) {
        return 0.6 + 0.35 * std::sin(9.0 * x / width) * std::cos(7.0 * y / width);
    });
}

// As placed dots do, none lies on the right or the lower edge, where there is no density.
bool on_page(const Dots& dots, const Density& density) {
    const double longer = density.longer_side();
    const double right = density.width() / longer, bottom = density.height() / longer;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const bool is_on = dots.x[i] >= 0 && dots.y[i] >= 0 && dots.x[i] < right && dots.y[i] < bottom;
        if (!is_on) return false;
    }
    return true;
}

// The slow reference: every dot against every other, in double precision; the centroid of a cell by many
// small triangles.
using Polygon = std::vector<glm::dvec2>;

Polygon half_of(const Polygon& polygon, glm::dvec2 normal, double most) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double over_a = glm::dot(a, normal) - most, over_b = glm::dot(b, normal) - most;
        if (over_a <= 0) result.push_back(a);
        if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
            result.push_back(a + (b - a) * (over_a / (over_a - over_b)));
    }
    return result;
}

// The centroid of density squared over what is nearer to dots[i] than to others, on the page and to where its
// edges wave, less the darker it is there: beyond them the density goes on.
glm::dvec2 slow_centroid(const std::vector<glm::dvec2>& dots, std::size_t i, const Density& density,
                         double scale) {
    const double longer = density.longer_side();
    const glm::dvec2 end(density.width() / longer, density.height() / longer), dot = dots[i];
    const auto at = [&](glm::dvec2 p) { return density.at(glm::clamp(p, glm::dvec2(1e-9), end - 1e-9)); };
    const double apart = 1 / std::sqrt(16 * scale * at(dot));
    // How far away an edge is where it waves.
    const auto edge = [&](double away, double from_middle) {
        double beyond = 0.05;
        for (const double length : {3.7, 5.9})
            beyond += 0.45 * 2 / std::numbers::pi *
                      std::asin(std::sin(2 * std::numbers::pi * std::abs(from_middle) / apart / length));
        const double light = std::clamp((0.98 - at(dot)) / 0.13, 0.0, 1.0);
        return std::max(away + std::lerp(0.2, std::clamp(beyond, -0.4, 0.35), light) * apart, 0.0);
    };
    const glm::dvec2 middle = dot - end / 2.0;
    const glm::dvec2 low(-edge(dot.x, middle.y), -edge(dot.y, middle.x)),
        high(edge(end.x - dot.x, middle.y), edge(end.y - dot.y, middle.x));
    Polygon cell{low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::size_t k = 0; k < dots.size(); ++k)
        if (k != i) cell = half_of(cell, dots[k] - dot, glm::dot(dots[k] - dot, dots[k] - dot) / 2);
    constexpr int kParts = 24;
    double weight = 0;
    glm::dvec2 moment(0);
    for (std::size_t c = 0; c < cell.size(); ++c) {
        const glm::dvec2 a = cell[c], b = cell[(c + 1) % cell.size()];
        const double area = std::abs(a.x * b.y - a.y * b.x);
        // Triangles point away from the dot, and between them towards it.
        for (int row = 0; row < kParts; ++row) {
            for (int k = 0; k < 2 * row + 1; ++k) {
                const double third = k % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
                const double to_b = k / 2 + third, from_top = row + (k % 2 == 0 ? 2.0 / 3 : 1.0 / 3);
                const glm::dvec2 p = (a * (from_top - to_b) + b * to_b) / double(kParts);
                const double d = at(dot + p);
                weight += area * d * d;
                moment += area * d * d * p;
            }
        }
    }
    return moment / weight;
}

}  // namespace

TEST_CASE("a step takes every dot 1.8 times the way to its cell's centroid") {
    for (const int width : {24, 60, 240}) {
        const int height = width * 2 / 3;
        const Density density(soft_picture(width, height));
        const Stippling before = numbered(placed(density, 350));
        const std::vector<glm::dvec2> dots = by_number(joined(before.dots));
        const std::vector<glm::dvec2> after = by_number(stepped(density, before));
        const double apart = 1 / std::sqrt(16 * before.scale);  // on black
        const double longer = density.longer_side();
        const glm::dvec2 end(width / longer, height / longer);
        double mean = 0, most = 0, way = 0;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 step = 1.8 * slow_centroid(dots, i, density, before.scale);
            const glm::dvec2 right = glm::clamp(dots[i] + step, glm::dvec2(0), end);
            const double error = glm::distance(after[i], right) / apart;
            mean += error / static_cast<double>(dots.size());
            most = std::max(most, error);
            way += glm::length(step) / apart / static_cast<double>(dots.size());
        }
        CAPTURE(width);
        CAPTURE(way);
        CHECK(way > 0.1);  // of the distance between dots
        CHECK(mean < 0.008);
        CHECK(most < 0.03);
    }
}

TEST_CASE("relaxed dots are the same to the bit with any number of threads") {
    const Density density(blotches(90, 60, 5));
    const Stippling before = placed(density, 12'000, true);
    const Dots one = relaxed(density, before, 3, 1);
    for (const int threads : {2, 3}) CHECK(same(relaxed(density, before, 3, threads), one));
}

TEST_CASE("relaxed dots are the same to the bit, however they are cut into pieces") {
    const Density density(soft_picture(60, 40));
    const Stippling before = placed(density, 3000, true);
    DotPieces pieces = split(joined(before.dots));
    REQUIRE(relax(pieces, density, 2, {.scale = before.scale}));
    CHECK(same(joined(pieces), relaxed(density, before, 2)));
}

TEST_CASE("no dot is lost, none leaves the page, and each keeps what is known of it") {
    const std::array grids{soft_picture(60, 40), blotches(40, 70, 2), Grid<float>(50, 50, 1.0f),
                           picture_of(80, 40, [](int x, int y) { return x == 0 || y == 39 ? 1.0 : 0.003; })};
    for (const Grid<float>& grid : grids) {
        const Density density(grid);
        Stippling before = placed(density, 2500, true);
        for (Dots& piece : before.dots.pieces) {
            piece.radius.resize(piece.size());
            for (std::size_t i = 0; i < piece.size(); ++i) piece.radius[i] = 0.001f * piece.threshold[i];
        }
        const auto columns = [](const Dots& dots) {
            std::vector<std::tuple<float, float, float>> result;
            for (std::size_t i = 0; i < dots.size(); ++i)
                result.emplace_back(dots.threshold[i], dots.critical[i], dots.radius[i]);
            std::ranges::sort(result);
            return result;
        };
        for (const int steps : {1, 6}) {
            const Dots after = relaxed(density, before, steps);
            REQUIRE(after.size() == 2500);
            REQUIRE(after.threshold.size() == 2500);
            REQUIRE(after.critical.size() == 2500);
            REQUIRE(after.radius.size() == 2500);
            CHECK(columns(after) == columns(joined(before.dots)));
            CHECK(on_page(after, density));
        }
    }
}

TEST_CASE("relaxing draws no line along the page's edges, however often") {
    const Density grey(Grid<float>(30, 20, 0.5f));
    const double height = 2.0 / 3;
    // Dots in bands a quarter of a distance wide, over what they would be evenly spread, of several drawings.
    constexpr int kBands = 6;
    for (const int steps : {3, 5, 20}) {
        CAPTURE(steps);
        std::array<double, kBands> bands{}, even{};
        for (const std::uint64_t count : {4000u, 5000u, 7000u, 9000u}) {
            const Dots dots = relaxed(grey, placed(grey, count), steps);
            const double band = std::sqrt(height / double(count)) / 4;
            for (const glm::dvec2 p : positions(dots)) {
                const double from_edge = std::min({p.x, 1 - p.x, p.y, height - p.y});
                if (from_edge < kBands * band) ++bands[static_cast<std::size_t>(from_edge / band)];
            }
            for (double& expected : even) expected += 2 * (1 + height) * band / height * double(count);
        }
        for (std::size_t i = 1; i < kBands; ++i) {
            CAPTURE(i);
            CHECK(bands[i] / even[i] == doctest::Approx(1).epsilon(0.2));
        }
    }
}

TEST_CASE("what travels with a dot stays near it") {
    const Density density(soft_picture(60, 40));
    const Stippling before = numbered(placed(density, 2000));
    const std::vector<glm::dvec2> from = by_number(joined(before.dots)),
                                  to = by_number(relaxed(density, before, 1));
    double farthest = 0;
    for (std::size_t i = 0; i < to.size(); ++i) farthest = std::max(farthest, glm::distance(from[i], to[i]));
    CHECK(farthest < 3 / std::sqrt(16 * before.scale));
}

TEST_CASE("dots on one grey get more even") {
    for (const float grey : {1.0f, 0.2f}) {
        const Density density(Grid<float>(32, 32, grey));
        const Stippling before = placed(density, 4000);
        const auto evenness = [](const Dots& dots) {
            return nearest_summary(positions(dots), {1, 1, Topology::window});
        };
        NearestSummary last = evenness(joined(before.dots));
        for (const int steps : {1, 2, 3, 10}) {
            const NearestSummary now = evenness(relaxed(density, before, steps));
            CAPTURE(grey);
            CAPTURE(steps);
            CHECK(now.mean > last.mean);
            CHECK(now.p1 > 0.85 * last.p1);  // at the edges a first step brings some nearer
            if (steps >= 3) {
                CHECK(now.mean >= 0.84);
                CHECK(now.p1 >= 0.62);
            }
            last = now;
        }
    }
}

TEST_CASE("a line one pixel wide stays a line, and its dots spread evenly along it") {
    for (const bool upright : {false, true}) {
        const Density density(
            picture_of(100, 100, [&](int x, int y) { return (upright ? x : y) == 37 ? 1.0 : 0.0; }));
        for (const int count : {30, 60, 200}) {
            const Dots after = relaxed(density, placed(density, static_cast<std::uint64_t>(count)), 10);
            for (const float across : upright ? after.x : after.y) CHECK(std::abs(across * 100 - 37.5f) < 1);
        }
        // Further apart than the line is wide they stand in single file.
        const Dots after = relaxed(density, placed(density, 30), 100);
        const FloatBuffer &across = upright ? after.x : after.y, &along = upright ? after.y : after.x;
        for (const float place : across) CHECK(std::abs(place * 100 - 37.5f) < 0.2f);
        std::vector<float> sorted(along.begin(), along.end());
        std::ranges::sort(sorted);
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            CHECK(sorted[i] - sorted[i - 1] > 0.75f / 30);
            CHECK(sorted[i] - sorted[i - 1] < 1.25f / 30);
        }
        CHECK(sorted.front() < 0.03f);
        CHECK(sorted.back() > 0.97f);
    }
}

TEST_CASE("a picture on its side is relaxed as it is upright") {
    const Grid<float> upright = soft_picture(60, 40);
    const Grid<float> turned = picture_of(40, 60, [&](int x, int y) { return upright.at(y, x); });
    const Grid<float> mirrored = picture_of(60, 40, [&](int x, int y) { return upright.at(59 - x, 39 - y); });
    const Density density(upright);
    const Stippling before = numbered(placed(density, 2000));
    const std::vector<glm::dvec2> right = by_number(stepped(density, before));
    const auto farthest = [&](const Grid<float>& grid, const std::function<glm::vec2(float, float)>& to,
                              const std::function<glm::dvec2(glm::dvec2)>& back) {
        Stippling moved{.dots = in_one_piece(joined(before.dots)), .scale = before.scale};
        Dots& dots = moved.dots.pieces[0];
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::vec2 place = to(dots.x[i], dots.y[i]);
            dots.x[i] = place.x;
            dots.y[i] = place.y;
        }
        const std::vector<glm::dvec2> found = by_number(stepped(Density(grid), moved));
        double result = 0;
        for (std::size_t i = 0; i < right.size(); ++i)
            result = std::max(result, glm::distance(back(found[i]), right[i]));
        return result * std::sqrt(16 * before.scale);
    };
    CHECK(farthest(
              turned, [](float x, float y) { return glm::vec2(y, x); },
              [](glm::dvec2 p) { return glm::dvec2(p.y, p.x); }) < 0.02);
    const float height = 40.0f / 60;
    CHECK(farthest(
              mirrored, [&](float x, float y) { return glm::vec2(1 - x, height - y); },
              [&](glm::dvec2 p) { return glm::dvec2(1 - p.x, height - p.y); }) < 0.02);
}

TEST_CASE("a slanted line of many dots stays within a pixel of itself") {
    const Density density(picture_of(100, 100, [](int x, int y) { return y == 20 + x / 2 ? 1.0 : 0.0; }));
    const Dots after = relaxed(density, placed(density, 400), 10);
    for (const glm::dvec2 p : positions(after)) CHECK(density.at(p) > 0);
}

TEST_CASE("white stays empty") {
    const std::array grids{blotches(40, 30, 3), blotches(12, 12, 7), picture_of(60, 60, [](int x, int y) {
                               return (x / 10 + y / 10) % 2 == 0 ? 0.0 : 0.05 + 0.9 * x / 60;
                           })};
    for (const Grid<float>& grid : grids) {
        const Density density(grid);
        for (const int steps : {1, 4, 15}) {
            int on_white = 0;
            for (const glm::dvec2 p : positions(relaxed(density, placed(density, 1500), steps)))
                on_white += density.at(p) <= 0;
            CHECK(on_white == 0);
        }
    }
}

TEST_CASE("a dot between two lines whose cell holds parts of both stays on its own") {
    // Dots further apart along a line than the lines are: the balance point of a cell lies in the white.
    const Density density(picture_of(256, 256, [](int x, int) { return x % 16 == 8 || x % 16 == 13; }));
    const Stippling from = placed(density, 400);
    for (const int steps : {1, 3, 10}) {
        double least = 1;
        for (const glm::dvec2 p : positions(relaxed(density, from, steps)))
            least = std::min(least, density.at(p));
        CHECK(least > 0);  // white has none
    }
}

TEST_CASE("areas with white between them keep their dots") {
    const Density density(picture_of(90, 60, [](int x, int y) {
        const bool rows = y > 15 && y < 45;
        return rows && ((x > 10 && x < 40) || (x > 50 && x < 80)) ? (x < 45 ? 1.0 : 0.5) : 0.0;
    }));
    const auto on_left = [](const Dots& dots) {
        return std::ranges::count_if(dots.x, [](float x) { return x < 0.5f; });
    };
    const Stippling before = placed(density, 3000);
    const auto placed_left = on_left(joined(before.dots));
    CHECK(placed_left > 1900);
    for (const int steps : {1, 10, 30})
        CHECK(std::abs(on_left(relaxed(density, before, steps)) - placed_left) <= 3);
}

TEST_CASE("relaxed dots keep the density that they were placed with") {
    for (const double light : {0.5, 0.2, 0.05}) {
        const Density density(picture_of(80, 40, [&](int x, int) { return x < 40 ? 1.0 : light; }));
        const Stippling before = placed(density, 8000);
        const auto on_left = [](const Dots& dots) {
            return static_cast<double>(std::ranges::count_if(dots.x, [](float x) { return x < 0.5f; }));
        };
        const double left = on_left(joined(before.dots)), right = 8000 - left;
        // At an edge so sharp the first row of the lighter side may go over to the darker.
        const double row = 0.5 * std::sqrt(16 * before.scale * light);
        for (const int steps : {1, 4, 10}) {
            const double moved = std::abs(on_left(relaxed(density, before, steps)) - left);
            CAPTURE(light);
            CAPTURE(steps);
            CHECK(moved / left < 0.01);
            CHECK(moved < 0.01 * right + 1.2 * row);
        }
    }
}

TEST_CASE("a slope keeps its dots in each of its strips") {
    const Density density(picture_of(100, 50, [](int x, int) { return 0.1 + 0.9 * (x + 0.5) / 100; }));
    const Stippling before = placed(density, 8000);
    const auto strips = [](const Dots& dots) {
        std::array<double, 10> counts{};
        for (const float x : dots.x) counts[std::min(static_cast<std::size_t>(x * 10), std::size_t{9})] += 1;
        return counts;
    };
    for (const int steps : {4, 10}) {
        const auto after = strips(relaxed(density, before, steps));
        for (std::size_t i = 0; i < after.size(); ++i) {
            // The strip's share of the density's integral.
            const double share = (0.1 + 0.9 * (static_cast<double>(i) + 0.5) / 10) / (10 * 0.55);
            CAPTURE(steps);
            CAPTURE(i);
            CHECK(after[i] == doctest::Approx(8000 * share).epsilon(0.03));
        }
    }
}

TEST_CASE("no step changes nothing to the bit, and no dots stay none") {
    const Density density(soft_picture(30, 20));
    const Stippling before = placed(density, 500, true);
    CHECK(same(relaxed(density, before, 0), joined(before.dots)));
    DotPieces none;
    CHECK(relax(none, density, 5, {.scale = 100}));
    CHECK(none.size() == 0);
    DotPieces empty = in_one_piece({});
    CHECK(relax(empty, density, 5, {.scale = 100}));
    CHECK(empty.size() == 0);
    Relaxation nothing({}, density, {.scale = 100});
    CHECK(nothing.step());
    CHECK(nothing.dots().size() == 0);
}

TEST_CASE("a dot alone on a grey page goes to its middle") {
    const Density density(Grid<float>(20, 20, 0.5f));
    Dots one;
    one.x = {0.3f};
    one.y = {0.8f};
    DotPieces dots = in_one_piece(one);
    REQUIRE(relax(dots, density, 20, {.scale = 1.0 / 8}));
    REQUIRE(dots.size() == 1);
    const Dots after = joined(dots);
    CHECK(after.x[0] == doctest::Approx(0.5).epsilon(0.02));
    CHECK(after.y[0] == doctest::Approx(0.5).epsilon(0.02));
}

TEST_CASE("dots at the very same place, or on the page's corners, do no harm") {
    const Density density(Grid<float>(20, 12, 0.5f));
    Dots dots;
    for (const auto& [x, y] :
         {std::pair(0.0f, 0.0f), {0.0f, 0.0f}, {1.0f, 0.6f}, {1.0f, 0.0f}, {0.5f, 0.3f}, {0.5f, 0.3f}}) {
        dots.x.push_back(x);
        dots.y.push_back(y);
    }
    DotPieces pieces = in_one_piece(dots);
    REQUIRE(relax(pieces, density, 10, {.scale = 2}));
    const Dots after = joined(pieces);
    CHECK(after.size() == 6);
    CHECK(on_page(after, density));
}

TEST_CASE("dots come row after row of the page, and in each from the left to the right") {
    const Density density(soft_picture(60, 40));
    const Stippling before = placed(density, 3000);
    const Dots after = relaxed(density, before, 2);
    const double row = relaxing_row(before.scale);
    CHECK(std::log2(row) == std::floor(std::log2(row)));
    int wrong = 0;
    for (std::size_t i = 1; i < after.size(); ++i) {
        const double last = std::floor(after.y[i - 1] / row), now = std::floor(after.y[i] / row);
        wrong += now < last || (now == last && after.x[i] < after.x[i - 1]);
    }
    CHECK(wrong == 0);
}

TEST_CASE("dots within the rim decide alone where those inside it go") {
    const Density density(soft_picture(60, 60));
    const Stippling before = placed(density, 40'000);
    const double rim = relaxing_rim(before.scale, 1);
    REQUIRE(rim < 0.3);
    const auto inside = [](const Dots& dots, double from) {
        Dots result;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            if (dots.y[i] < from || dots.x[i] < from) continue;
            result.x.push_back(dots.x[i]);
            result.y.push_back(dots.y[i]);
        }
        return result;
    };
    DotPieces part = in_one_piece(inside(joined(before.dots), 0.7 - rim));
    RelaxingRequest request;
    request.scale = before.scale;
    request.carried = std::make_shared<const Displacement>();
    DotPieces all = before.dots;
    REQUIRE(relax(all, density, 1, request));
    REQUIRE(relax(part, density, 1, request));
    const Dots whole = inside(joined(all), 0.7);
    CHECK(whole.size() > 1000);
    CHECK(same(inside(joined(part), 0.7), whole));
}

TEST_CASE("a step that is stopped leaves the dots as they were") {
    const Density density(soft_picture(30, 20));
    const Stippling before = placed(density, 500, true);
    std::stop_source stop;
    Relaxation relaxation(before.dots, density, {.scale = before.scale});
    REQUIRE(relaxation.step());
    const Dots once = joined(relaxation.dots());
    stop.request_stop();
    CHECK_FALSE(relaxation.step({}, stop.get_token()));
    CHECK(same(joined(relaxation.dots()), once));
    DotPieces dots = before.dots;
    CHECK_FALSE(relax(dots, density, 3, {.scale = before.scale}, stop.get_token()));
    CHECK(same(joined(dots), joined(before.dots)));
}
