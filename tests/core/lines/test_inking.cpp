#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "core/lines/inking.h"
#include "core/output/sample_band.h"

using namespace dapple;

namespace {

InkLine straight(glm::dvec2 from, glm::dvec2 to, float width) {
    InkLine line{.points = {}, .widths = {}, .strength = 1};
    for (int i = 0; i <= 20; ++i) {
        line.points.push_back(from + (to - from) * (i / 20.0));
        line.widths.push_back(width);
    }
    return line;
}

InkArea disc(glm::dvec2 middle, double radius) {
    InkArea area{{{}}};
    for (int i = 0; i <= 90; ++i) {
        const double angle = i % 90 * (2 * std::numbers::pi / 90);
        area.rings[0].push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return area;
}

// The share of a square of side 100 mm that is covered.
double covered(const std::vector<InkArea>& shapes) {
    constexpr int kPixels = 400;
    SampleBand band(kPixels, kPixels);
    for (InkArea shape : shapes) {
        for (auto& ring : shape.rings)
            for (glm::dvec2& p : ring) p *= kPixels * kSamples / 100.0;
        band.add_shape(shape.rings);
    }
    const Grid<float> grid = band.coverage(kPixels);
    return std::accumulate(grid.values.begin(), grid.values.end(), 0.0) / (kPixels * kPixels);
}

double covered(const Strokes& strokes, double pen_mm) {
    constexpr int kPixels = 400;
    SampleBand band(kPixels, kPixels);
    const double samples = kPixels * kSamples / 100.0;
    stream_of(strokes, pen_mm).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
        for (std::size_t i = 1; i < points.size(); ++i)
            band.add_capsule(points[i - 1] * samples, points[i] * samples, pen_mm / 2 * samples);
    });
    const Grid<float> grid = band.coverage(kPixels);
    return std::accumulate(grid.values.begin(), grid.values.end(), 0.0) / (kPixels * kPixels);
}

constexpr Rectangle<double> kPage{{0, 0}, {1, 1}};

Density flat(float value) {
    return Density(Grid<float>(400, 400, value));
}

}  // namespace

TEST_CASE("a line's shape is as wide as it and has round ends") {
    const Inking inking{.lines = {straight({0.2, 0.5}, {0.8, 0.5}, 0.02F)}, .areas = {}, .white = {}};
    const double wanted = 0.6 * 0.02 + std::numbers::pi * 0.01 * 0.01;
    CHECK(covered(shapes_of(inking, kPage, 100)) == doctest::Approx(wanted).epsilon(0.01));
}

TEST_CASE("a closed line's shape is a ring") {
    InkLine circle{.points = disc({0.5, 0.5}, 0.3).rings[0], .widths = {}, .strength = 1};
    circle.widths.assign(circle.points.size(), 0.02F);
    const double wanted = 2 * std::numbers::pi * 0.3 * 0.02;
    CHECK(covered(shapes_of({.lines = {circle}, .areas = {}, .white = {}}, kPage, 100)) ==
          doctest::Approx(wanted).epsilon(0.01));
}

TEST_CASE("the parts of a page have together what the whole has") {
    const Inking inking{
        .lines = {straight({0.1, 0.3}, {0.9, 0.8}, 0.03F)}, .areas = {disc({0.5, 0.5}, 0.2)}, .white = {}};
    const auto part = [&](double left, double top) {
        return covered(shapes_of(inking, {{left, top}, {left + 0.5, top + 0.5}}, 100));
    };
    const double parts = part(0, 0) + part(0.5, 0) + part(0, 0.5) + part(0.5, 0.5);
    CHECK(parts == doctest::Approx(covered(shapes_of(inking, kPage, 100))).epsilon(0.005));
}

TEST_CASE("a pen fills a black and reaches nowhere beyond it") {
    const Inking inking{.lines = {}, .areas = {disc({0.5, 0.5}, 0.2)}, .white = {}};
    const double area = covered(shapes_of(inking, kPage, 100));
    for (const double pen_mm : {0.5, 1.0, 2.0}) {
        CAPTURE(pen_mm);
        CHECK(covered(strokes_of(inking, pen_mm, 100), pen_mm) == doctest::Approx(area).epsilon(0.01));
    }
}

TEST_CASE("a pen goes over a wide line as often as it takes") {
    const Inking inking{.lines = {straight({0.2, 0.4}, {0.8, 0.6}, 0.03F)}, .areas = {}, .white = {}};
    CHECK(covered(strokes_of(inking, 1, 100), 1) ==
          doctest::Approx(covered(shapes_of(inking, kPage, 100))).epsilon(0.03));
    CHECK(strokes_of(inking, 4, 100).ends.size() == 1);
}

TEST_CASE("dots beside lines and blacks bring the ink that is missing, and none lies in these") {
    const Inking inking{
        .lines = {straight({0.1, 0.2}, {0.9, 0.2}, 0.01F)}, .areas = {disc({0.5, 0.6}, 0.15)}, .white = {}};
    const Density density = flat(0.4F);
    const InkCurve ink;
    const Grid<float> seen(400, 400, 1 - ink.coverage(0.4F));
    const Grid<float> room = room_for_dots(inking, density, seen, ink, {.radius = 0.004, .spacing = 0.01});
    const Grid<float> inked = coverage(inking.lines, inking.areas, 0, 400, 400);
    double line = 0, beside = 0;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 400; ++x) {
            CHECK((inked.at(x, y) < 0.99F || room.at(x, y) < 0.02F));
            const double ink_there = ink.coverage(0.4F * room.at(x, y)) + inked.at(x, y);
            if (x > 80 && x < 320 && y > 40 && y < 120) line += ink_there, ++beside;
        }
    }
    // Around the line there is as much ink as anywhere.
    CHECK(line / beside == doctest::Approx(ink.coverage(0.4F)).epsilon(0.02));
    CHECK(room.at(200, 380) == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("a line between parts that are nearly black is white") {
    const Inking inking{.lines = {straight({0.1, 0.5}, {0.9, 0.5}, 0.004F)}, .areas = {}, .white = {}};
    const DotsAmongLines dots{.radius = 0.003, .spacing = 0.01};
    const Inking in_black = fitted(inking, Grid<float>(400, 400, 0.05F), dots);
    CHECK(in_black.lines.empty());
    CHECK(in_black.white.size() == 1);
    Grid<float> edge(400, 400, 0.05F);
    std::fill_n(edge.values.begin(), 400 * 200, 0.7F);
    CHECK(fitted(inking, edge, dots).lines.size() == 1);
    CHECK(fitted(inking, edge, dots).white.empty());
}

TEST_CASE("no dots are left to stand alone in the light") {
    Grid<float> values(400, 400, 0.5F);
    for (int y = 0; y < 400; ++y)
        for (int x = 200; x < 400; ++x) values.at(x, y) = 0.5F / 12;
    const Grid<float> room = room_for_dots({}, Density(values), Grid<float>(400, 400, 0.5F), InkCurve(),
                                           {.radius = 0.003, .spacing = 0.01});
    CHECK(room.at(300, 200) == 0);
    CHECK(room.at(100, 200) == doctest::Approx(1).epsilon(0.01));
}
