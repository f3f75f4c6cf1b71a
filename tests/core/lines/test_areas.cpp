#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/image/tone.h"
#include "core/lines/ink_areas.h"

using namespace dapple;

namespace {

Grid<float> encoded_picture(int width, int height, const std::function<double(double x, double y)>& value) {
    Grid<float> light(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            light.at(x, y) = srgb_to_linear(static_cast<float>(value(x + 0.5, y + 0.5)));
    return light;
}

double signed_area(const std::vector<glm::dvec2>& ring) {
    double twice = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        twice += ring[i - 1].x * ring[i].y - ring[i].x * ring[i - 1].y;
    return twice / 2;
}

double area_of(const InkArea& area) {
    double sum = 0;
    for (const auto& ring : area.rings) {
        CHECK(ring.size() > 3);
        CHECK(ring.front() == ring.back());
        CHECK((signed_area(ring) > 0) == (&ring == &area.rings.front()));
        sum += signed_area(ring);
    }
    return sum;
}

double sum_of(const Grid<float>& grid) {
    double sum = 0;
    for (const float v : grid.values) sum += static_cast<double>(v);
    CHECK(std::ranges::all_of(grid.values, [](float v) { return v >= 0 && v <= 1; }));
    return sum;
}

InkArea rectangle(double left, double top, double right, double bottom) {
    return {{{{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}}};
}

}  // namespace

TEST_CASE("a black disc is one area of its size, specks of paper in it are filled") {
    constexpr int kSize = 500;
    constexpr double kRadius = 120;
    const auto areas =
        find_blacks(encoded_picture(kSize, kSize,
                                    [](double x, double y) {
                                        if (std::hypot(x - 220, y - 240) < 2) return 0.9;
                                        return std::hypot(x - 250, y - 250) < kRadius ? 0.02 : 0.8;
                                    }),
                    0.9, 0.02);
    REQUIRE(areas.size() == 1);
    CHECK(areas[0].rings.size() == 1);
    CHECK(area_of(areas[0]) * kSize * kSize ==
          doctest::Approx(std::numbers::pi * kRadius * kRadius).epsilon(0.02));
    double most = 0;
    for (const glm::dvec2 p : areas[0].rings[0])
        most = std::max(most, std::abs(glm::distance(p * double(kSize), {250, 250}) - kRadius));
    CHECK(most < 2);
}

TEST_CASE("a ring has one hole, with an island that is an area of its own") {
    constexpr int kSize = 500;
    const auto areas = find_blacks(encoded_picture(kSize, kSize,
                                                   [](double x, double y) {
                                                       const double r = std::hypot(x - 250, y - 250);
                                                       return r < 40 || (r > 90 && r < 160) ? 0.03 : 0.7;
                                                   }),
                                   0.9, 0.02);
    REQUIRE(areas.size() == 2);
    const InkArea &island = areas[0], &ring = areas[1];
    CHECK(island.rings.size() == 1);
    REQUIRE(ring.rings.size() == 2);
    const double pixels = kSize * kSize;
    CHECK(area_of(island) * pixels == doctest::Approx(std::numbers::pi * 40 * 40).epsilon(0.04));
    CHECK(area_of(ring) * pixels == doctest::Approx(std::numbers::pi * (160 * 160 - 90 * 90)).epsilon(0.02));
}

TEST_CASE("lines of light stay in what is black, thin black ones and grey are no areas") {
    const auto light_line = find_blacks(
        encoded_picture(500, 500, [](double x, double) { return std::abs(x - 250) < 2 ? 0.4 : 0.03; }), 0.9,
        0.02);
    CHECK(light_line.size() == 2);
    CHECK(find_blacks(
              encoded_picture(500, 500, [](double x, double) { return std::abs(x - 250) < 0.5 ? 0.0 : 0.2; }),
              0.9, 0.02)
              .empty());
    CHECK(find_blacks(Grid<float>(500, 400, srgb_to_linear(0.15f)), 0.9, 0.02).empty());
    CHECK(find_blacks(
              encoded_picture(500, 500,
                              [](double x, double y) { return std::hypot(x - 99, y - 99) < 6 ? 0.0 : 0.6; }),
              0.9, 0.03)
              .empty());
}

TEST_CASE("what is black to the edge of the picture reaches it") {
    for (const auto& size : {std::pair(200, 100), std::pair(1, 90), std::pair(3000, 700)}) {
        const int width = size.first, height = size.second;
        CAPTURE(width);
        CAPTURE(height);
        const double longer = std::max(width, height);
        const auto areas = find_blacks(Grid<float>(width, height, 0.0f), 0.9, 0);
        REQUIRE(areas.size() == 1);
        CHECK(area_of(areas[0]) * longer * longer == doctest::Approx(width * height).epsilon(0.01));
        CHECK(find_blacks(Grid<float>(width, height, 1.0f), 0.9, 0).empty());
        CHECK(sum_of(coverage({}, areas, 0, width, height)) == doctest::Approx(width * height).epsilon(0.01));
    }
    CHECK(find_blacks(Grid<float>(1, 1, 0.0f), 0.9, 0).size() == 1);
    CHECK(find_blacks(Grid<float>(3, 3, 0.0f), 0.9, 0).size() == 1);
    CHECK(find_blacks({}, 0.9, 0.01).empty());
    CHECK(find_blacks(Grid<float>(100, 100, std::numeric_limits<float>::quiet_NaN()), 0.9, 0.01).size() == 1);
}

TEST_CASE("coverage is what geometry says, widened by the gap") {
    const auto covered = [](const std::vector<InkLine>& lines, const std::vector<InkArea>& areas,
                            double gap) { return sum_of(coverage(lines, areas, gap, 400, 300)); };
    const auto pixels = [](double units) { return doctest::Approx(units * 400 * 400); };
    const InkArea box = rectangle(0.2, 0.1, 0.5, 0.4033);
    CHECK(covered({}, {box}, 0) == pixels(0.3 * 0.3033).epsilon(0.001));
    const double gap = 0.03, round = std::numbers::pi * gap * gap;
    CHECK(covered({}, {box}, gap) == pixels(0.3 * 0.3033 + 2 * (0.3 + 0.3033) * gap + round).epsilon(0.003));
    // A line with round ends, then one that is narrower than a pixel, then one that widens.
    const InkLine line{{{0.2, 0.3}, {0.6, 0.5}}, {0.02f, 0.02f}, 1};
    const double length = std::hypot(0.4, 0.2);
    CHECK(covered({line}, {}, 0) == pixels(length * 0.02 + std::numbers::pi * 0.01 * 0.01).epsilon(0.01));
    CHECK(covered({line}, {}, 0.01) == pixels(length * 0.04 + std::numbers::pi * 0.02 * 0.02).epsilon(0.01));
    const InkLine hair{{{0.2, 0.30125}, {0.6, 0.30125}}, {0.001f, 0.001f}, 1};
    CHECK(covered({hair}, {}, 0) == pixels(0.4 * 0.001).epsilon(0.03));
    const InkLine wedge{{{0.2, 0.3}, {0.6, 0.3}}, {0.01f, 0.05f}, 1};
    CHECK(covered({wedge}, {}, 0) ==
          pixels(0.4 * 0.03 + std::numbers::pi * (0.005 * 0.005 + 0.025 * 0.025) / 2).epsilon(0.02));
    // A hole is paper, what overlaps counts once, and what lies outside does not.
    InkArea frame = box;
    frame.rings.push_back({{0.3, 0.2}, {0.3, 0.3}, {0.4, 0.3}, {0.4, 0.2}, {0.3, 0.2}});
    CHECK(covered({}, {frame}, 0) == pixels(0.3 * 0.3033 - 0.01).epsilon(0.001));
    CHECK(covered({}, {box, box}, 0) == pixels(0.3 * 0.3033).epsilon(0.001));
    CHECK(covered({}, {rectangle(-5, -5, 0.1, 5)}, 0) == pixels(0.1 * 0.75).epsilon(0.001));
    CHECK(covered({InkLine{{{-3, -3}, {-2, -2}}, {0.1f, 0.1f}, 1}}, {}, 0.1) == 0);
}

TEST_CASE("what of a line lies outside the areas is left, in pieces") {
    const InkLine line{{{0.1, 0.2}, {0.9, 0.2}}, {0.001f, 0.003f}, 0.7f};
    const auto pieces = outside({line}, {rectangle(0.3, 0.1, 0.6, 0.4)}, 0.01);
    REQUIRE(pieces.size() == 2);
    const std::vector<glm::dvec2> ends{{0.1, 0.2}, {0.29, 0.2}, {0.61, 0.2}, {0.9, 0.2}};
    for (int i = 0; i < 2; ++i) {
        CHECK(glm::distance(pieces[i].points.front(), ends[2 * i]) < 0.003);
        CHECK(glm::distance(pieces[i].points.back(), ends[2 * i + 1]) < 0.003);
        CHECK(pieces[i].strength == 0.7f);
    }
    CHECK(pieces[0].widths.front() == 0.001f);
    CHECK(std::abs(pieces[0].widths.back() - 0.001475f) < 1e-5f);
    CHECK(pieces[1].widths.back() == 0.003f);
    CHECK(outside({line}, {}, 0.01)[0].points == line.points);
    CHECK(outside({line}, {rectangle(0, 0, 1, 1)}, 0).empty());
    // A ring that is crossed nowhere stays closed.
    InkLine ring{{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.1}}, std::vector<float>(4, 0.002f), 1};
    CHECK(outside({ring}, {rectangle(0.5, 0.5, 0.6, 0.6)}, 0.01)[0].closed());
}

TEST_CASE("areas are the same with one thread and with two") {
    const Grid<float> light = encoded_picture(
        300, 200, [](double x, double y) { return 0.15 + 0.15 * std::sin(x * 0.05) * std::cos(y * 0.08); });
    const auto all = find_blacks(light, 0.88, 0.01);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = find_blacks(light, 0.88, 0.01);
    REQUIRE(all.size() > 2);
    REQUIRE(all.size() == alone.size());
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].rings == alone[i].rings);
}
