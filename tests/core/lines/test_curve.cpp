#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/lines/ink_lines.h"

using namespace dapple;

namespace {

std::vector<glm::dvec2> circle(int points, double radius) {
    std::vector<glm::dvec2> ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    ring.push_back(ring.front());
    return ring;
}

glm::dvec2 at(const Cubic& c, double t) {
    const double s = 1 - t;
    return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

double angle_between(glm::dvec2 a, glm::dvec2 b) {
    return std::acos(std::min(glm::dot(a, b) / (glm::length(a) * glm::length(b)), 1.0));
}

}  // namespace

TEST_CASE("a line with fewer points stays within the tolerance, and keeps widths with points") {
    std::vector<glm::dvec2> points;
    std::vector<float> widths;  // next to nothing, and which point it is
    constexpr float kOne = 1.0f / (1 << 30);
    const auto place = [](float width) { return static_cast<std::size_t>(width / kOne); };
    for (int i = 0; i <= 1000; ++i) {
        points.push_back({i * 0.001, 0.1 * std::sin(i * 0.01)});
        widths.push_back(static_cast<float>(i) * kOne);
    }
    const auto all = points;
    simplify(points, widths);
    CHECK(points.size() < 120);
    REQUIRE(points.size() == widths.size());
    CHECK(points.front() == all.front());
    CHECK(points.back() == all.back());
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(points[i] == all[place(widths[i])]);
    for (std::size_t i = 1; i < points.size(); ++i)
        for (std::size_t k = place(widths[i - 1]); k < place(widths[i]); ++k) {
            const glm::dvec2 along = glm::normalize(points[i] - points[i - 1]), from = all[k] - points[i - 1];
            CHECK(std::abs(along.x * from.y - along.y * from.x) <= 1e-4);
        }
    // A straight line that widens and narrows keeps the point where it is widest.
    std::vector<glm::dvec2> straight{{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}, {0.4, 0}};
    std::vector<float> swelling{0.001f, 0.002f, 0.003f, 0.002f, 0.001f};
    simplify(straight, swelling);
    CHECK(straight == std::vector<glm::dvec2>{{0, 0}, {0.2, 0}, {0.4, 0}});
    CHECK(swelling == std::vector<float>{0.001f, 0.003f, 0.001f});
    std::vector<glm::dvec2> two{{0, 0}, {1, 1}};
    std::vector<float> none;
    simplify(two, none);
    CHECK(two.size() == 2);
}

TEST_CASE("a ring's curve is round and closes smoothly") {
    auto ring = circle(16, 2);
    const auto curve = smooth_curve(ring);
    REQUIRE(curve.size() == 16);
    CHECK(curve.front()[0] == curve.back()[3]);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        for (int k = 0; k <= 10; ++k)
            CHECK(glm::length(at(curve[i], k / 10.0)) == doctest::Approx(2).epsilon(0.002));
        const Cubic& next = curve[(i + 1) % curve.size()];
        CHECK(curve[i][3] == next[0]);
        CHECK(angle_between(curve[i][3] - curve[i][2], next[1] - next[0]) < 1e-6);
    }
}

TEST_CASE("a corner stays a corner, a straight line straight") {
    const std::vector<glm::dvec2> corner{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}};
    const auto curve = smooth_curve(corner);
    REQUIRE(curve.size() == 4);
    for (int k = 0; k <= 10; ++k) {
        CHECK(std::abs(at(curve[1], k / 10.0).y) < 1e-12);
        CHECK(std::abs(at(curve[2], k / 10.0).x - 2) < 1e-12);
    }
    const auto two = smooth_curve(std::vector<glm::dvec2>{{0, 0}, {3, 3}});
    REQUIRE(two.size() == 1);
    CHECK(glm::distance(two[0][1], {1, 1}) < 1e-12);
}

TEST_CASE("points at unequal distances make no loops") {
    const std::vector<glm::dvec2> uneven{{0, 0}, {1, 0}, {1.02, 0.01}, {1.03, 0.03}, {2, 1}};
    for (const Cubic& c : smooth_curve(uneven))
        for (int k = 1; k <= 20; ++k) CHECK(at(c, k / 20.0).x > at(c, (k - 1) / 20.0).x);
}
