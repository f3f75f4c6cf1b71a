#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/analysis/autocorrelation.h"
#include "tests/point_sets.h"

using namespace dapple;

namespace {

double ring_area(const PairCorrelation& pairs, std::size_t bin) {
    const double inner = double(bin) * pairs.bin_width, outer = inner + pairs.bin_width;
    return std::numbers::pi * (outer * outer - inner * inner);
}

}  // namespace

TEST_CASE("white noise has a pair correlation of 1, on a torus and in a window") {
    for (const Topology topology : {Topology::torus, Topology::window}) {
        // The window is narrow, so that most pairs of the longer distances are cut by its edges.
        const Domain domain{1, 0.1, topology};
        const auto points = white_noise(5000, 21, domain);
        const auto pairs = pair_correlation(points, domain, {.highest_distance = 20, .bin_width = 2});
        REQUIRE(pairs.g.size() == 10);
        for (const double g : pairs.g) CHECK(g == doctest::Approx(1).epsilon(0.025));
    }
}

TEST_CASE("a square lattice has 4 neighbours at 1, 4 at sqrt 2, 4 at 2 and 8 at sqrt 5") {
    const auto pairs = pair_correlation(square_lattice(40), {}, {.highest_distance = 2.4, .bin_width = 0.07});
    const double of_others = 1600.0 / 1599;
    std::vector<double> neighbours;
    for (std::size_t bin = 0; bin < pairs.g.size(); ++bin) {
        const double count = pairs.g[bin] * ring_area(pairs, bin) / of_others;
        if (count > 0) neighbours.push_back(count);
    }
    REQUIRE(neighbours.size() == 4);
    CHECK(neighbours[0] == doctest::Approx(4).epsilon(1e-9));
    CHECK(neighbours[1] == doctest::Approx(4).epsilon(1e-9));
    CHECK(neighbours[2] == doctest::Approx(4).epsilon(1e-9));
    CHECK(neighbours[3] == doctest::Approx(8).epsilon(1e-9));
}

TEST_CASE("fewer than two points have no pairs, and few points count through their images") {
    CHECK(pair_correlation({}, {}).g.size() == 100);
    const std::vector<glm::dvec2> two{{0.1, 0.1}, {0.6, 0.1}};
    const auto pairs = pair_correlation(two, {}, {.highest_distance = 10, .bin_width = 0.1});
    double partners = 0;
    for (std::size_t bin = 0; bin < pairs.g.size(); ++bin)
        partners += pairs.g[bin] * ring_area(pairs, bin) / 2;  // 2 = n / (n - 1)
    // Images of the other point within 10 / sqrt 2 = 7.07: half-integer x, integer y.
    int expected = 0;
    for (int x = -8; x < 8; ++x)
        for (int y = -8; y <= 8; ++y) expected += std::hypot(x + 0.5, y) < 10 / std::sqrt(2.0);
    CHECK(partners == doctest::Approx(expected));
}
