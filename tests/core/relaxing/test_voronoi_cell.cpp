// Cells against the definition: what is nearer to the dot than to any other.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/relaxing/lloyd_steps.h"

using namespace dapple;

namespace {

struct Rectangle {
    float left, top, right, bottom;
};

struct Scene {
    Rectangle around;  // with the dot in it
    std::vector<glm::vec2> others;
    std::vector<float> ahead = {};  // of each, in a power diagram
};

Scene random_scene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> side(0.2f, 2.0f), place(-2.0f, 2.0f);
    Scene scene{{-side(random), -side(random), side(random), side(random)}, {}};
    for (auto i = random() % 60; i > 0; --i) {
        const float x = place(random);
        scene.others.emplace_back(x, place(random));
    }
    return scene;
}

VoronoiCell cell_of(const Scene& scene) {
    const float most = scene.ahead.empty() ? 0 : std::max(std::ranges::max(scene.ahead), 0.0f);
    VoronoiCell cell(scene.around.left, scene.around.top, scene.around.right, scene.around.bottom, most);
    for (std::size_t i = 0; i < scene.others.size(); ++i)
        cell.cut(scene.others[i].x, scene.others[i].y, scene.ahead.empty() ? 0 : scene.ahead[i]);
    return cell;
}

glm::dvec2 corner(const VoronoiCell& cell, int i) {
    return {cell[i % cell.size()].x, cell[i % cell.size()].y};
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

double area(const VoronoiCell& cell) {
    double twice = 0;
    for (int i = 0; i < cell.size(); ++i) twice += cross(corner(cell, i), corner(cell, i + 1));
    return twice / 2;
}

bool holds(const VoronoiCell& cell, glm::dvec2 p) {
    for (int i = 0; i < cell.size(); ++i)
        if (cross(corner(cell, i + 1) - corner(cell, i), p - corner(cell, i)) < 0) return false;
    return true;
}

// How much nearer a place is to the dot than to the nearest other, in squares of distances.
double nearer_by(const Scene& scene, glm::dvec2 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.others.size(); ++i) {
        const glm::dvec2 away = p - glm::dvec2(scene.others[i]);
        nearest = std::min(nearest, glm::dot(away, away) - (scene.ahead.empty() ? 0 : scene.ahead[i]));
    }
    return nearest - glm::dot(p, p);
}

// Random places that belong to the cell by one of the two alone, and how many lay inside and outside.
struct Places {
    int wrong = 0, inside = 0, outside = 0;

    void try_some(const Scene& scene, const VoronoiCell& cell, unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> x(scene.around.left, scene.around.right),
            y(scene.around.top, scene.around.bottom);
        for (int i = 0; i < 400; ++i) {
            const double to_x = x(random);
            const glm::dvec2 p(to_x, y(random));
            const double margin = nearer_by(scene, p);
            if (std::abs(margin) < 1e-5) continue;  // on the border, where rounding decides
            wrong += holds(cell, p) != (margin > 0);
            ++(margin > 0 ? inside : outside);
        }
    }
};

bool same(const VoronoiCell& a, const VoronoiCell& b) {
    if (a.size() != b.size()) return false;
    for (int i = 0; i < a.size(); ++i)
        if (a[i].x != b[i].x || a[i].y != b[i].y) return false;
    return true;
}

}  // namespace

TEST_CASE("a place belongs to the cell exactly if no other dot is nearer") {
    Places places;
    for (unsigned seed = 0; seed < 150; ++seed) {
        const Scene scene = random_scene(seed);
        places.try_some(scene, cell_of(scene), seed + 1000);
        CAPTURE(seed);
        CHECK(places.wrong == 0);
    }
    CHECK(places.inside > 5000);
    CHECK(places.outside > 5000);
}

TEST_CASE("cells are convex, their corners go round clockwise as seen on a page, and they hold their dot") {
    for (unsigned seed = 0; seed < 400; ++seed) {
        const VoronoiCell cell = cell_of(random_scene(seed));
        CAPTURE(seed);
        REQUIRE(cell.size() >= 3);
        double least_turn = 0;
        for (int i = 0; i < cell.size(); ++i) {
            const glm::dvec2 a = corner(cell, i), b = corner(cell, i + 1), c = corner(cell, i + 2);
            least_turn = std::min(least_turn, cross(b - a, c - b));
            CHECK(cell[i].distance2 == doctest::Approx(glm::dot(a, a)).epsilon(1e-5));
        }
        CHECK(least_turn > -1e-6);
        CHECK(holds(cell, {0, 0}));
    }
}

TEST_CASE("the cells of regular lattices are squares and hexagons") {
    const double height = std::sqrt(3.0) / 2;
    std::vector<glm::vec2> square, hexagonal;
    for (int row = -3; row <= 3; ++row) {
        for (int column = -3; column <= 3; ++column) {
            if (row == 0 && column == 0) continue;
            square.emplace_back(column, row);
            hexagonal.emplace_back(column + 0.5 * (std::abs(row) % 2), row * height);
        }
    }
    const VoronoiCell four = cell_of({{-4, -4, 4, 4}, square});
    CHECK(area(four) == doctest::Approx(1).epsilon(1e-5));
    CHECK(four.reach2() == doctest::Approx(2).epsilon(1e-5));
    const VoronoiCell six = cell_of({{-4, -4, 4, 4}, hexagonal});
    CHECK(six.size() == 6);
    CHECK(area(six) == doctest::Approx(height).epsilon(1e-5));
    CHECK(six.reach2() == doctest::Approx(4.0 / 3).epsilon(1e-5));
}

TEST_CASE("the order of the cuts changes no more than the last bits") {
    for (unsigned seed = 0; seed < 100; ++seed) {
        Scene scene = random_scene(seed);
        const double expected = area(cell_of(scene));
        std::ranges::reverse(scene.others);
        CHECK(area(cell_of(scene)) == doctest::Approx(expected).epsilon(1e-4));
    }
}

TEST_CASE(
    "a dot at the reach or beyond cuts nothing, one just within it in the farthest corner's direction does") {
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const VoronoiCell cell = cell_of(random_scene(seed));
        const double reach = std::sqrt(double{cell.reach2()});
        for (int i = 0; i < 64; ++i) {
            const double angle = 2 * std::numbers::pi * i / 64;
            for (const double away : {1.00001, 1.5, 20.0}) {
                VoronoiCell other = cell;
                other.cut(static_cast<float>(away * reach * std::cos(angle)),
                          static_cast<float>(away * reach * std::sin(angle)));
                CHECK(same(other, cell));
            }
        }
        int farthest = 0;
        for (int i = 1; i < cell.size(); ++i)
            if (cell[i].distance2 > cell[farthest].distance2) farthest = i;
        VoronoiCell cut = cell;
        cut.cut(1.99f * cell[farthest].x, 1.99f * cell[farthest].y);
        CHECK(area(cut) < area(cell));
        CHECK(cut.reach2() <= cell.reach2());
    }
}

TEST_CASE("more neighbours than a cell has room for leave it convex and too large, not broken") {
    std::vector<glm::vec2> circle;
    for (int i = 0; i < 60; ++i) {
        const double angle = 2 * std::numbers::pi * i / 60;
        circle.emplace_back(std::cos(angle), std::sin(angle));
    }
    const VoronoiCell cell = cell_of({{-4, -4, 4, 4}, circle});
    CHECK(cell.size() <= 24);
    CHECK(area(cell) > std::numbers::pi / 4 * 0.999);
    CHECK(area(cell) < 4.0);
    for (int i = 0; i < cell.size(); ++i)
        CHECK(cross(corner(cell, i + 1) - corner(cell, i), corner(cell, i + 2) - corner(cell, i + 1)) >
              -1e-6);
}

TEST_CASE("in a power diagram a place belongs to the dot whose circle it is least far from") {
    Places places;
    for (unsigned seed = 0; seed < 150; ++seed) {
        Scene scene = random_scene(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> share(-0.7f, 0.7f);  // as far as one circle may swallow another
        for (const glm::vec2 other : scene.others)
            scene.ahead.push_back(share(random) * glm::dot(other, other));
        const VoronoiCell cell = cell_of(scene);
        CAPTURE(seed);
        CHECK(holds(cell, {0, 0}));
        places.try_some(scene, cell, seed + 1000);
        CHECK(places.wrong == 0);
        // What is beyond its reach leaves it as it is.
        VoronoiCell after = cell;
        const float reach = 1.001f * std::sqrt(cell.reach2());
        const float most = scene.ahead.empty() ? 0 : std::max(std::ranges::max(scene.ahead), 0.0f);
        for (int turn = 0; turn < 32; ++turn) {
            const double angle = turn * std::numbers::pi / 16;
            after.cut(reach * float(std::cos(angle)), reach * float(std::sin(angle)), most);
        }
        CHECK(same(after, cell));
    }
    CHECK(places.inside > 3000);
    CHECK(places.outside > 5000);
}

TEST_CASE("however large another dot is, each keeps the place where it lies") {
    VoronoiCell cell(-1, -1, 1, 1, 100);
    cell.cut(0.5f, 0.25f, 100);
    CHECK(holds(cell, {0, 0}));
    CHECK(!holds(cell, {0.25, 0.125}));  // half the way
}
