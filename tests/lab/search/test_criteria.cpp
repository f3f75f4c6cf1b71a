#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lab/search/criteria.h"
#include "lab/search/relink_search.h"

using namespace dapple;

namespace {

Rule rule_of(int a, int b, int c, int d) {
    return Rule{{Orientation{std::uint8_t(a)}, Orientation{std::uint8_t(b)}, Orientation{std::uint8_t(c)},
                 Orientation{std::uint8_t(d)}}};
}

Tile annealed() {
    return make_tile(rule_of(3, 7, 6, 0), {"0301213303211022"});
}

// The orientation of every tile after so many subdivisions.
std::vector<Orientation> orientation_map(const Rule& rule, int levels) {
    const int side = 1 << levels;
    std::vector<Orientation> map(std::size_t(side) * std::size_t(side));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            Orientation g;
            for (int bit = levels - 1; bit >= 0; --bit) {
                const int place = (x >> bit & 1) + 2 * (y >> bit & 1);
                g = compose(g, rule.child[apply_to_quadrant(inverse(g), place)]);
            }
            map[std::size_t(y * side + x)] = g;
        }
    }
    return map;
}

}  // namespace

TEST_CASE("relative radii are the published ones") {
    CHECK(relative_radius(make_tile(14217, 2895, 16)) == doctest::Approx(0.652788).epsilon(1e-6));
    CHECK(relative_radius(annealed()) == doctest::Approx(0.5985).epsilon(1e-4));
    CHECK(relative_radius(make_tile(rule_of(2, 4, 5, 6), {"1003221202313301"})) ==
          doctest::Approx(0.638).epsilon(1e-3));
}

TEST_CASE("between levels the paper's tile keeps the radii that its three orders are known for") {
    const Tile tile = make_tile(14217, 2895, 16);
    CHECK(worst_relative_radius(tile, rank(tile, RankingMethod::farthest)) ==
          doctest::Approx(0.612).epsilon(1e-3));
    CHECK(worst_relative_radius(tile, rank(tile, RankingMethod::paper)) ==
          doctest::Approx(0.357).epsilon(2e-3));
    CHECK(worst_relative_radius(tile, rank(tile, RankingMethod::energy)) ==
          doctest::Approx(0.42).epsilon(2e-2));
}

TEST_CASE("coherent share and low-frequency power are the published ones") {
    const Tile paper = make_tile(14217, 2895, 16);
    CHECK(coherent_share(paper) == doctest::Approx(1));
    CHECK(low_frequency_power(paper) == doctest::Approx(0.120).epsilon(5e-3));
    CHECK(coherent_share(annealed()) == doctest::Approx(0.118).epsilon(5e-3));
    CHECK(low_frequency_power(annealed()) == doctest::Approx(0.067).epsilon(5e-3));
}

TEST_CASE("letters are counted by quadrant") {
    CHECK(letter_counts(make_tile(14217, 2895, 16)) == std::array{4, 4, 4, 4});
    CHECK(letter_counts(make_tile(Rule{}, {"0001", "22>1", "33>2"})) == std::array{3, 1, 2, 2});
}

TEST_CASE("a lattice is known for one") {
    const Tile even = make_tile(Rule{}, even_words(64, 1));
    CHECK(lattice_share(even) < 0.5);
    CHECK(lattice_share(make_tile(14217, 2895, 16)) > lattice_share(even));
    // The cycle of (1, 4) / 15 under doubling is a lattice in a row: every difference of two is one of the
    // others.
    CHECK(lattice_share(make_tile(1, 4, 4)) >= 0.5);
    CHECK(lattice_share(make_tile(1, 4, 4)) <= 1);
}

TEST_CASE("orientations coincide as often as in a subdivision made by hand") {
    const int lags = 5, levels = 8, side = 1 << levels;
    for (const Rule& rule : {rule_of(3, 7, 6, 0), rule_of(1, 0, 0, 4)}) {
        const auto map = orientation_map(rule, levels);
        const auto highest = orientation_coincidence(rule, lags);
        REQUIRE(highest.size() == lags);
        for (int lag = 1; lag <= lags; ++lag) {
            double most = 0;
            for (int dy = 0; dy <= lag; ++dy) {
                for (int dx = -lag; dx <= lag; ++dx) {
                    if (std::max(std::abs(dx), dy) != lag) continue;
                    int equal = 0, all = 0;
                    for (int y = 0; y + dy < side; ++y) {
                        for (int x = std::max(0, -dx); x < side && x + dx < side; ++x) {
                            equal +=
                                map[std::size_t(y * side + x)] == map[std::size_t((y + dy) * side + x + dx)];
                            ++all;
                        }
                    }
                    most = std::max(most, double(equal) / all);
                }
            }
            CHECK(highest[std::size_t(lag - 1)] == doctest::Approx(most).epsilon(0.03));
        }
    }
}

TEST_CASE("the aperiodic rule's orientations stay apart at every lag, the identity's never") {
    const auto apart = orientation_coincidence(rule_of(3, 7, 6, 0), 16);
    for (const double share : apart) {
        CHECK(share > 0.1);
        CHECK(share < 0.17);
    }
    for (const double share : orientation_coincidence(Rule{}, 64)) CHECK(share == doctest::Approx(1));
}

TEST_CASE("the identity rule has the torus for neighbours, the aperiodic one about sixty") {
    CHECK(legal_neighbours(Rule{}).size() == 8);
    CHECK(legal_neighbours(aperiodic_rule()).size() >= 50);
    CHECK(legal_neighbours(aperiodic_rule()).size() <= 64);
}
