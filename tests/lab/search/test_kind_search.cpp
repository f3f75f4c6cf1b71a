// The search for tiles of several kinds.

#include <doctest/doctest.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <vector>

#include "lab/search/criteria.h"
#include "lab/search/kind_links.h"
#include "lab/search/kind_search.h"
#include "lab/search/relink_search.h"
#include "tests/densities.h"

namespace dapple {
namespace {

Tile torus_tile(std::size_t points) {
    RelinkSettings settings;
    settings.rule = Rule{};
    settings.points = points;
    settings.moves = 1'000 * points;
    settings.peak_weight = 0;
    return relink_search(settings).tile;
}

KindSearchSettings search(const Tile& start, int kinds, std::uint64_t moves) {
    KindSearchSettings settings;
    settings.start = start;
    settings.kinds = kinds;
    settings.moves = moves;
    return settings;
}

// The energy of all kinds, pair by pair, in spacings from the tile's corner: as the header says it.
double energy_of(const Tile& tile, const PairShape& shape, double apart) {
    const double side = std::sqrt(static_cast<double>(tile.size())), kinds = double(tile.kinds());
    const auto weight = [&](glm::dvec2 p) {
        const double from_border = std::min({p.x, p.y, side - p.x, side - p.y});
        const double t = std::clamp(from_border - 0.5, 0.0, 1.0);
        return t * t * (3 - 2 * t);
    };
    double energy = 0;
    for (std::size_t i = 0; i < tile.points.size(); ++i) {
        const glm::dvec2 a = side * to_unit_square(tile.points[i]);
        for (std::size_t j = 0; j < tile.points.size(); ++j) {
            const glm::dvec2 b = side * to_unit_square(tile.points[j]);
            const auto squared = [](glm::dvec2 d) { return d.x * d.x + d.y * d.y; };
            for (int x = -1; x <= 1; ++x) {
                for (int y = -1; y <= 1; ++y) {
                    if (x == 0 && y == 0) continue;
                    const double d2 = squared(b + side * glm::dvec2(x, y) - a);
                    energy += pair_energy(shape, d2) / kinds / 2;
                }
            }
            if (j >= i) continue;
            if (tile.kind_of(i) == tile.kind_of(j)) energy += pair_energy(shape, squared(b - a));
            const PairShape narrow{.tone_width = 0.5, .close_weight = 0, .close_radius = 1, .tone_weight = 1};
            energy += apart * weight(a) * weight(b) * pair_energy(narrow, squared(b - a) * kinds);
        }
    }
    return energy;
}

/// Islands in threads, each of which waits for all others.
class Archipelago {
 public:
    explicit Archipelago(int islands) : have_(std::size_t(islands)), all_are_there_(islands) {}

    std::vector<KindSearchResult> search(const KindSearchSettings& settings,
                                         std::stop_token first_stops = {}) {
        std::vector<KindSearchResult> found(have_.size());
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < have_.size(); ++i) {
            threads.emplace_back([this, &settings, &found, first_stops, i] {
                KindSearchSettings own = settings;
                own.island = static_cast<int>(i);
                if (i == 0) own.stop = first_stops;
                own.best = [this, i](const Island& island) { return best(i, island); };
                found[i] = kind_search(own);
            });
        }
        threads.clear();
        return found;
    }
    int exchanges() const { return exchanges_; }

 private:
    Island best(std::size_t i, const Island& island) {
        have_[i] = island;
        all_are_there_.arrive_and_wait();
        Island best = *std::ranges::min_element(have_, {}, &Island::energy);
        best.stops = std::ranges::any_of(have_, &Island::stops);
        if (i == 0) ++exchanges_;
        all_are_there_.arrive_and_wait();
        return best;
    }

    std::vector<Island> have_;
    std::barrier<> all_are_there_;
    int exchanges_ = 0;
};

}  // namespace

TEST_CASE("the energy that the search lowers is that of all pairs, one by one, after any number of moves") {
    const KindSearchSettings settings = search(torus_tile(100), 3, 30'000);
    const Tile tile = kind_search(settings).tile;
    KindLinks links(tile.next_kind, island_of(tile, 0).letters, tile.successor, settings.shape);
    REQUIRE(links.set_apart(0.3));
    const auto check = [&] {
        const Tile now = make_tile(Rule{}, tile.next_kind, island_of(tile, 0).letters, links.successors());
        CHECK(links.energy() == doctest::Approx(energy_of(now, settings.shape, 0.3)).epsilon(0.003));
    };
    check();
    Random random(5);
    int taken = 0;
    for (int i = 0; i < 5'000; ++i) taken += links.step(random, 0.3, 1.5);
    CHECK(taken > 100);
    check();
    const double before = links.energy();
    links.refresh();
    CHECK(links.energy() == doctest::Approx(before).epsilon(0.003));
}

TEST_CASE("kinds that were annealed apart are evener than chance, differ, and are the same again") {
    KindSearchSettings settings = search(torus_tile(144), 4, 400'000);
    const KindSearchResult found = kind_search(settings), again = kind_search(settings);
    CHECK(found.moves == 400'000);
    CHECK(found.tile.kinds() == 4);
    CHECK(found.tile.size() == 144);
    CHECK(again.tile.points == found.tile.points);
    CHECK(again.energy == found.energy);
    CHECK(coherent_share(settings.start) == doctest::Approx(1));
    CHECK(coherent_share(found.tile) < 0.45);
    CHECK(low_frequency_power(found.tile) < 0.1);
    CHECK(low_frequency_power(random_kinds(Rule{}, found.tile.next_kind, 144, 2)) > 0.1);
    std::set<std::pair<std::uint64_t, std::uint64_t>> places;
    for (const BinaryPoint p : found.tile.points) places.insert({p.x, p.y});
    CHECK(places.size() > 0.9 * 4 * 144);
    settings.seed = 2;
    CHECK(kind_search(settings).tile.points != found.tile.points);
}

TEST_CASE("islands end with the same tile, which is better than what one of them finds, and the same again") {
    const KindSearchSettings settings = search(torus_tile(100), 3, 100'000);
    Archipelago archipelago(4);
    const std::vector<KindSearchResult> found = archipelago.search(settings);
    CHECK(archipelago.exchanges() == kExchanges);
    for (const KindSearchResult& each : found) {
        CHECK(each.tile.points == found[0].tile.points);
        CHECK(each.moves == 100'000);
        CHECK(each.energy == doctest::Approx(found[0].energy));
    }
    CHECK(found[0].energy < kind_search(settings).energy);
    CHECK(Archipelago(4).search(settings)[2].tile.points == found[0].tile.points);
}

TEST_CASE("where one island is stopped, all end") {
    std::stop_source stop;
    stop.request_stop();
    for (const KindSearchResult& each :
         Archipelago(3).search(search(torus_tile(100), 3, 100'000), stop.get_token()))
        CHECK(each.moves < 100'000);
}

TEST_CASE("a substitution has each kind once in each quadrant and rarely two alike at one distance") {
    for (const int kinds : {2, 5, 16}) {
        const NextKinds next = mixed_kinds(kinds, 1);
        REQUIRE(next.size() == static_cast<std::size_t>(kinds));
        for (std::size_t q = 0; q < 4; ++q) {
            std::set<std::uint16_t> seen;
            for (const auto& children : next) seen.insert(children[q]);
            CHECK(seen.size() == static_cast<std::size_t>(kinds));
            CHECK(*seen.rbegin() == kinds - 1);
        }
    }
    CHECK(std::ranges::max(kind_coincidence(mixed_kinds(16, 1), 8)) < 0.1);
    // Nor are the halves of a page alike, whichever the seed.
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        CHECK(page_coincidence(mixed_kinds(5, seed), 1) == 0);
        CHECK(page_coincidence(mixed_kinds(8, seed), 4) < 0.25);
    }
    CHECK_THROWS_AS(mixed_kinds(1, 1), std::runtime_error);
    CHECK_THROWS_AS(mixed_kinds(65, 1), std::runtime_error);
}

TEST_CASE("a search without moves still gives a tile, and one of turned copies is refused") {
    const KindSearchResult found = kind_search(search(torus_tile(64), 2, 0));
    CHECK(found.moves == 0);
    CHECK(found.tile.kinds() == 2);
    CHECK_THROWS_AS(kind_search(search(random_tile(kTurning, 64, 1), 2, 0)), std::runtime_error);
}

}  // namespace dapple
