// Penrose's rhombs, against what their geometry says and against brute force.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "lab/related/penrose.h"
#include "lab/related/penrose_tiling.h"
#include "lab/related/plain_voronoi.h"

namespace dapple {
namespace {

double twice_area(const PenroseTriangle& t) {
    const glm::dvec2 u = t.left - t.apex, v = t.right - t.apex;
    return std::abs(u.x * v.y - u.y * v.x);
}

double leg(const PenroseTriangle& t) {
    return std::hypot(t.left.x - t.apex.x, t.left.y - t.apex.y);
}

double degrees_at_apex(const PenroseTriangle& t) {
    return std::asin(twice_area(t) / (leg(t) * leg(t))) * 180 / std::numbers::pi;
}

const PenroseTriangle kLarge{.apex = {0, 0},
                             .left = {1, 0},
                             .right = {std::cos(std::numbers::pi / 5), std::sin(std::numbers::pi / 5)}};

struct Patch {
    std::vector<PenroseTriangle> triangles{kLarge};
    std::vector<PenroseVertex> last;  // of the last level
    std::vector<glm::dvec2> all;
};

Patch divided(int levels) {
    Patch patch;
    for (int level = 0; level < levels; ++level) {
        std::vector<PenroseTriangle> parts;
        patch.last.clear();
        for (const PenroseTriangle& triangle : patch.triangles) {
            const DividedTriangle divided = divide(triangle);
            for (const PenroseTriangle& part : divided.parts()) parts.push_back(part);
            for (const PenroseVertex& vertex : divided.born()) {
                patch.last.push_back(vertex);
                patch.all.push_back(vertex.place);
            }
        }
        patch.triangles = std::move(parts);
    }
    return patch;
}

// Far from the edges of the large triangle, beyond which nothing is divided.
bool is_inside(glm::dvec2 p) {
    return std::hypot(p.x - 0.68, p.y - 0.22) < 0.15;
}

std::pair<long, long> rounded(glm::dvec2 p) {
    return {std::lround(p.x * 1e7), std::lround(p.y * 1e7)};
}

}  // namespace

TEST_CASE("halves of Penrose's rhombs are divided into smaller halves that fill them") {
    for (const PenroseTriangle& triangle : divided(4).triangles) {
        const DividedTriangle parts = divide(triangle);
        double area = 0;
        for (const PenroseTriangle& part : parts.parts()) {
            area += twice_area(part);
            CHECK(leg(part) == doctest::Approx(leg(triangle) / kGolden));
            const bool acute = part.kind == PenroseKind::acute;
            // The sine of 108 degrees is that of 72.
            CHECK(degrees_at_apex(part) == doctest::Approx(acute ? 36 : 72));
        }
        CHECK(area == doctest::Approx(twice_area(triangle)));
    }
}

TEST_CASE(
    "each vertex of Penrose's tiling comes with one triangle alone, and as many come as there are rhombs") {
    const Patch patch = divided(12);
    std::map<std::pair<long, long>, int> born, corners;
    for (const glm::dvec2 p : patch.all)
        if (is_inside(p)) ++born[rounded(p)];
    double obtuse = 0;
    for (const PenroseTriangle& t : patch.triangles) {
        if (t.kind != PenroseKind::acute) ++obtuse;
        for (const glm::dvec2 p : {t.apex, t.left, t.right})
            if (is_inside(p)) ++corners[rounded(p)];
    }
    CHECK(born.size() == corners.size());
    for (const auto& [place, times] : born) {
        CHECK(times == 1);
        CHECK(corners.contains(place));
    }
    const double area = std::numbers::pi * 0.15 * 0.15;
    CHECK(double(born.size()) ==
          doctest::Approx(penrose_vertices(leg(patch.triangles[0])) * area).epsilon(0.01));
    CHECK(obtuse / (double(patch.triangles.size()) - obtuse) == doctest::Approx(kGolden).epsilon(0.001));
}

TEST_CASE("the numbers of a level's new vertices fill the way from 0 to 1 evenly, everywhere") {
    std::vector<double> shares, here;
    for (const PenroseVertex& vertex : divided(13).last) {
        shares.push_back(vertex.share);
        if (is_inside(vertex.place)) here.push_back(vertex.share);
    }
    for (std::vector<double>* some : {&shares, &here}) {
        REQUIRE(some->size() > 1000);
        std::ranges::sort(*some);
        for (std::size_t i = 0; i < some->size(); ++i)
            REQUIRE((*some)[i] ==
                    doctest::Approx((double(i) + 0.5) / double(some->size())).scale(1).epsilon(0.01));
    }
}

TEST_CASE(
    "Penrose's dots are as many as wanted, follow the density, and are moved to the middle of their cells") {
    for (const std::size_t count : {1000UL, 1600UL, 2100UL}) {
        const PlainDots placed = penrose_vertices_only({.count = count}),
                        moved = penrose_tiles({.count = count});
        CHECK(placed.size() == count);
        CHECK(moved.size() == count);
        const PlainDots fewer = penrose_vertices_only({.count = count / 2});
        CHECK(std::equal(fewer.begin(), fewer.end(), placed.begin()));
        // Mean way from a dot to its cell's centroid, away from the edge: what moving them is for.
        const auto off_centre = [](const PlainDots& dots) {
            const std::vector<CellMoments> cells = plain_cells(dots, {1, 1, Topology::window});
            double sum = 0;
            int some = 0;
            for (std::size_t i = 0; i < dots.size(); ++i) {
                const glm::dvec2 p = dots[i], way = cells[i].first / cells[i].weight;
                if (std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y)) < 0.1) continue;
                sum += std::hypot(way.x, way.y);
                ++some;
            }
            return sum / some;
        };
        CHECK(off_centre(moved) < 0.45 * off_centre(placed));
    }
    Grid<float> values(40, 20);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) values.at(x, y) = x < 20 ? 0.75f : 0.25f;
    const Density density(std::move(values));
    const PlainDots dots = penrose_tiles({.density = &density, .count = 4000});
    CHECK(dots.size() == 4000);
    const auto left = std::ranges::count_if(dots, [](glm::dvec2 p) { return p.x < 0.5; });
    CHECK(double(left) == doctest::Approx(3000).epsilon(0.02));
    CHECK(std::ranges::all_of(dots, [](glm::dvec2 p) { return p.y < 0.5; }));
}

}  // namespace dapple
