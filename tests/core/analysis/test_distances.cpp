#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "core/analysis/distances.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("the hexagonal lattice has nearest distances of 1, the square lattice of sqrt(sqrt(3) / 2)") {
    const PointSet hexagonal = hexagonal_lattice(20, 12);
    const NearestSummary hex = nearest_summary(hexagonal.points, hexagonal.domain);
    CHECK(hex.minimum == doctest::Approx(1).epsilon(1e-12));
    CHECK(hex.p1 == doctest::Approx(1).epsilon(1e-12));
    CHECK(hex.mean == doctest::Approx(1).epsilon(1e-12));

    const NearestSummary square = nearest_summary(square_lattice(30), {});
    CHECK(square.minimum == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)).epsilon(1e-12));
    CHECK(square.mean == doctest::Approx(0.9306048591).epsilon(1e-9));
}

TEST_CASE("white noise has a mean nearest distance of half over the root of its density") {
    const Domain domain{2, 3, Topology::torus};
    const auto points = white_noise(40000, 7, domain);
    const double in_spacings = 0.5 * std::sqrt(2 * std::sqrt(3.0)) / 2;  // 0.5 sqrt(area / n) over 2 r_max
    CHECK(nearest_summary(points, domain).mean == doctest::Approx(in_spacings).epsilon(0.01));
}

TEST_CASE("nearest distances are those of trying all pairs, on a torus and in a window") {
    for (const Topology topology : {Topology::torus, Topology::window}) {
        const Domain domain{3, 0.5, topology};
        std::vector<glm::dvec2> points = white_noise(300, 3, domain);
        points.push_back(points.front());             // two points at the same place
        points.push_back({0.0, 0.0});                 // a corner
        points.push_back({2.9999999999, 0.4999999});  // the opposite one
        const std::vector<double> distances = nearest_distances(points, domain);
        for (std::size_t i = 0; i < points.size(); ++i) {
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t j = 0; j < points.size(); ++j) {
                glm::dvec2 d = points[i] - points[j];
                if (topology == Topology::torus) {
                    d.x -= domain.width * std::round(d.x / domain.width);
                    d.y -= domain.height * std::round(d.y / domain.height);
                }
                if (i != j) best = std::min(best, std::hypot(d.x, d.y));
            }
            CHECK(distances[i] == doctest::Approx(best).epsilon(1e-9));
        }
    }
}

TEST_CASE("one point is a square lattice on a torus and has no neighbour in a window") {
    const std::vector<glm::dvec2> one{{0.3, 0.9}};
    CHECK(nearest_distances(one, {1, 1, Topology::torus}).front() == doctest::Approx(1));
    CHECK(nearest_distances(one, {4, 0.25, Topology::torus}).front() == doctest::Approx(0.25));
    CHECK(std::isinf(nearest_distances(one, {1, 1, Topology::window}).front()));
    CHECK(nearest_summary(one, {1, 1, Topology::torus}).minimum == doctest::Approx(0.9306048591));
    CHECK(nearest_summary(one, {1, 1, Topology::window}).mean == 0);
    CHECK(nearest_summary({}, {}).mean == 0);
}

TEST_CASE("the first percentile lies between sorted distances") {
    // In a window: 100 pairs on a line, pair i being i + 1 wide, pairs far apart.
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 100; ++i) {
        points.push_back({1000.0 * i, 0.5});
        points.push_back({1000.0 * i + i + 1, 0.5});
    }
    const Domain domain{100000, 1, Topology::window};
    // 200 distances 1, 1, 2, 2, ...; place 1.99 is between the second and the third.
    const double spacing = 2 * largest_radius(domain, 200);
    CHECK(nearest_summary(points, domain).p1 * spacing == doctest::Approx(1.99));
}

TEST_CASE("a search radius over a period meets every image of every point") {
    const std::vector<glm::dvec2> one{{0.25, 0.75}};
    const PointGrid grid(one, {1, 1, Topology::torus});
    int count = 0;
    grid.for_each_within({0.25, 0.75}, 2.1, [&](std::uint32_t, glm::dvec2) { ++count; });
    CHECK(count == 13);  // (0,0), 4 at 1, 4 at sqrt 2, 4 at 2
}

TEST_CASE("points beyond the edge are wrapped on a torus and refused in a window") {
    const std::vector<glm::dvec2> points{{-0.25, 1.5}, {-1e-18, 1.0}};
    const auto inside = points_inside(points, {1, 1, Topology::torus});
    CHECK(inside[0] == glm::dvec2(0.75, 0.5));
    CHECK(inside[1] == glm::dvec2(0, 0));
    CHECK_THROWS_AS(points_inside(points, {1, 1, Topology::window}), std::runtime_error);
    CHECK_THROWS_WITH(points_inside(points, {1, 0, Topology::torus}, "a.csv"),
                      "a.csv: a domain of 1 x 0 has no area; give two positive sides");
    const std::vector<glm::dvec2> odd{{0.5, std::nan("")}};
    CHECK_THROWS_WITH(points_inside(odd, {}, "a.csv"),
                      "a.csv: point 1 is at (0.5, nan); every coordinate must be a finite number");
}
