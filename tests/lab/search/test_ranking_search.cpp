#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lab/search/ranking_search.h"
#include "lab/search/relink_search.h"

using namespace dapple;

namespace {

// Every stage by itself, every pair of points that are there, one by one; without the pairs of the tile's own
// points among themselves.
double energy_by_brute_force(const Tile& tile, const Ranking& ranking,
                             const RankingSearchSettings& settings) {
    const auto neighbours = legal_neighbours(tile.rule);
    const auto newborns = newborns_of(tile);
    const double count = double(tile.size());
    double sum = 0;
    for (int s = 1; s < settings.stages; ++s) {
        const double size = count * std::pow(4.0, double(s) / settings.stages);
        std::vector<glm::dvec2> places;
        for (const BinaryPoint p : tile.points) places.push_back(to_unit_square(p));
        for (std::size_t i = 0; i < newborns.size(); ++i) {
            if (double(ranking.newborn[i]) <= size) places.push_back(to_unit_square(newborns[i].position));
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t j = 0; j < places.size(); ++j) {
                if (i < tile.size() && j < tile.size()) continue;
                const auto pair = [&](glm::dvec2 other) {
                    const glm::dvec2 d = other - places[i];
                    return pair_energy(settings.shape, (d.x * d.x + d.y * d.y) * size) / 2;
                };
                if (i != j) sum += pair(places[j]);
                for (const Neighbour& n : neighbours) sum += n.probability * pair(position_in(n, places[j]));
            }
        }
    }
    return sum / double(newborns.size());
}

}  // namespace

TEST_CASE("the energy of a ranking is the sum over stages of the pairs that are there") {
    const Tile tile = make_tile(aperiodic_rule(), even_words(16, 3));
    RankingSearchSettings settings;
    settings.stages = 5;
    settings.shape.close_weight =
        1;  // distances lie in bins, and the steeper an energy is the more that tells
    for (const RankingMethod order : {RankingMethod::farthest, RankingMethod::energy}) {
        const Ranking ranking = rank(tile, order);
        CHECK(ranking_energy(tile, ranking, settings) ==
              doctest::Approx(energy_by_brute_force(tile, ranking, settings)).epsilon(2e-3));
    }
}

TEST_CASE("the search finds an order of lower energy, each place taken once, the same for the same seed") {
    const Tile tile = make_tile(aperiodic_rule(), even_words(64, 3));
    RankingSearchSettings settings;
    settings.exchanges = 30'000;
    const Ranking greedy = rank(tile, RankingMethod::energy);
    const Ranking found = search_ranking(tile, settings);
    CHECK(energy_by_brute_force(tile, found, settings) < energy_by_brute_force(tile, greedy, settings));
    CHECK(found.tile == greedy.tile);
    const std::set<float> ranks(found.newborn.begin(), found.newborn.end());
    CHECK(ranks.size() == 3 * 64);
    CHECK(*ranks.begin() == 64.5f);
    CHECK(*ranks.rbegin() == 255.5f);
    CHECK(search_ranking(tile, settings).newborn == found.newborn);
}
