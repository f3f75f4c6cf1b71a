#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stop_token>
#include <vector>

#include "lab/search/coherent_peaks.h"
#include "lab/search/relink_search.h"
#include "lab/search/rule_search.h"
#include "tests/tile_words.h"

using namespace dapple;

namespace {

// Every pair of a point and a copy, one by one.
double energy_by_brute_force(const Tile& tile, const PairShape& shape) {
    const double spacings = std::sqrt(double(tile.size()));
    const auto neighbours = legal_neighbours(tile.rule);
    double sum = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const glm::dvec2 p = to_unit_square(tile.points[i]);
        const auto pair = [&](glm::dvec2 other) {
            const glm::dvec2 d = (other - p) * spacings;
            return pair_energy(shape, d.x * d.x + d.y * d.y);
        };
        for (std::size_t j = 0; j < tile.size(); ++j) {
            const glm::dvec2 other = to_unit_square(tile.points[j]);
            if (i != j) sum += pair(other) / 2;
            for (const Neighbour& n : neighbours) sum += n.probability * pair(position_in(n, other)) / 2;
        }
    }
    return sum / double(tile.size());
}

RelinkSettings small_search() {
    RelinkSettings settings;
    settings.points = 64;
    settings.moves = 40'000;
    settings.seed = 7;
    settings.peak_weight = 0;
    return settings;
}

}  // namespace

TEST_CASE("the search's energy is that of all pairs in a large subdivision, each counted once") {
    for (const std::size_t points : {4u, 16u, 20u, 64u}) {
        const Tile tile = make_tile(aperiodic_rule(), even_words(points, 3));
        const PairShape shape;
        CHECK(relink_energy(tile, shape) ==
              doctest::Approx(energy_by_brute_force(tile, shape)).epsilon(1e-4));
    }
    const Tile paper = make_tile(14217, 2895, 16);
    const PairShape narrow{0.3, 10, 1.0, 0.25};
    CHECK(relink_energy(paper, narrow) ==
          doctest::Approx(energy_by_brute_force(paper, narrow)).epsilon(1e-4));
}

TEST_CASE("a search lowers the energy, and the tile it returns has the energy it tells") {
    const RelinkSettings settings = small_search();
    const RelinkResult result = relink_search(settings);
    CHECK(result.moves == settings.moves);
    const double start =
        energy_by_brute_force(make_tile(settings.rule, even_words(64, settings.seed)), settings.shape);
    const double end = energy_by_brute_force(result.tile, settings.shape);
    CHECK(end < 0.8 * start);
    CHECK(result.energy == doctest::Approx(end).epsilon(1e-4));
}

TEST_CASE("what the search returns is a tile: the half-size tile covers each quadrant's points") {
    const RelinkResult result = relink_search(small_search());
    REQUIRE(result.tile.size() == 64);
    const auto words = words_of(result.tile.points, result.tile.rule);
    const Tile again = make_tile(result.tile.rule, words);
    REQUIRE(again.size() == 64);
    for (const BinaryPoint p : result.tile.points) {
        CHECK(std::count(again.points.begin(), again.points.end(), p) == 1);
    }
    CHECK(newborns_of(result.tile).size() == 3 * 64);
}

TEST_CASE("the same seed finds the same tile, another seed another") {
    RelinkSettings settings = small_search();
    settings.moves = 5000;
    settings.peak_weight = 0.01;
    const auto words = relink_search(settings).tile.words;
    CHECK(relink_search(settings).tile.words == words);
    const auto several = relink_searches(settings, 3);
    REQUIRE(several.size() == 3);
    CHECK(several[0].energy <= several[1].energy);
    CHECK(several[1].energy <= several[2].energy);
    CHECK(std::any_of(several.begin(), several.end(),
                      [&](const RelinkResult& r) { return r.tile.words == words; }));
    settings.seed = 8;
    CHECK(relink_search(settings).tile.words != words);
}

TEST_CASE("a search that is stopped returns the best so far") {
    RelinkSettings settings = small_search();
    std::stop_source source;
    settings.stop = source.get_token();
    double best = 0;
    int reports = 0;
    settings.progress = [&](const RelinkProgress& progress) {
        best = progress.best;
        CHECK(make_tile(settings.rule, progress.words).size() == 64);
        if (++reports == 1) source.request_stop();
    };
    const RelinkResult result = relink_search(settings);
    CHECK(result.moves < settings.moves);
    CHECK(result.energy == best);
    CHECK(result.tile.size() == 64);
}

TEST_CASE("a search by a clock ends by it, and cools by it as one by moves does by them") {
    RelinkSettings settings = small_search();
    settings.moves = 10 * 4096;
    const RelinkResult by_moves = relink_search(settings);
    // A clock that is looked at once at the start and then after every 4,096 moves, and strikes each time.
    double struck = 0;
    settings.clock = [&] { return struck++; };
    settings.seconds = 10;
    settings.moves = 1;
    const RelinkResult by_clock = relink_search(settings);
    CHECK(by_clock.moves == by_moves.moves);
    CHECK(by_clock.tile.words == by_moves.tile.words);
    settings.seconds = 1e-9;
    CHECK(relink_search(settings).moves > 0);
}

TEST_CASE("a search whose time is over before it begins ends all the same") {
    std::stop_source patience;
    for (const double seconds : {0.0, -1.0, 1e-300}) {
        CAPTURE(seconds);
        RelinkSettings settings = small_search();
        int looks = 0;
        settings.clock = [&] {
            if (++looks == 100) patience.request_stop();
            return static_cast<double>(looks);
        };
        settings.stop = patience.get_token();
        settings.seconds = seconds;
        CHECK(relink_search(settings).tile.size() == settings.points);
        const std::vector<Rule> rules{settings.rule, Rule{}};
        CHECK(search_rules(settings, rules, 1).tile.size() == settings.points);
    }
    CHECK_FALSE(patience.stop_requested());
}

TEST_CASE("runs by a clock take turns, so that all together last as long as one") {
    RelinkSettings settings = small_search();
    std::atomic<int> looks = 0;
    settings.clock = [&] { return static_cast<double>(looks++); };
    settings.seconds = 20;
    tbb::task_arena one(1);
    one.execute([&] { CHECK(relink_searches(settings, 5).size() == 5); });
    // Five times 4 strikes, and one more at the start of each.
    CHECK(looks == 25);
}

TEST_CASE("a search may start from points that crowd together") {
    RelinkSettings settings = small_search();
    settings.start = {std::string(40, '0').append("123").append(20, '1').append("2")};
    settings.moves = 2000;
    const RelinkResult result = relink_search(settings);
    const Tile start = make_tile(settings.rule, settings.start);
    CHECK(result.energy < relink_energy(start, settings.shape));
}

TEST_CASE("a search can go on from a tile") {
    RelinkSettings settings = small_search();
    settings.moves = 10'000;
    const RelinkResult first = relink_search(settings);
    settings.start = first.tile.words;
    settings.start_temperature = settings.end_temperature;
    CHECK(relink_search(settings).energy <= first.energy);
}

TEST_CASE("even words put equally many points into every square") {
    for (const std::size_t points : {4u, 16u, 48u, 64u, 256u}) {
        const Tile tile = make_tile(aperiodic_rule(), even_words(points, 5));
        std::size_t squares = 4;
        while (points % (squares * 4) == 0) squares *= 4;
        const double side = std::sqrt(double(squares));
        std::vector<std::size_t> held(squares);
        for (const BinaryPoint p : tile.points) {
            const glm::dvec2 at = to_unit_square(p) * side;
            ++held[std::size_t(at.y) * std::size_t(side) + std::size_t(at.x)];
        }
        for (const std::size_t n : held) CHECK(n == points / squares);
    }
    CHECK_THROWS_WITH(even_words(30, 1),
                      "a tile of 30 points cannot be made; use a multiple of 4 up to 4096");
}

TEST_CASE("the coherent power is that of the mean over the eight orientations") {
    const Tile tile = make_tile(aperiodic_rule(), even_words(16, 2));
    const double side = 4;
    std::vector<glm::dvec2> positions;
    for (const BinaryPoint p : tile.points) positions.push_back((to_unit_square(p) - 0.5) * side);
    const auto highest = [&](const std::vector<glm::dvec2>& at) {
        double best = 0, penalty = 0;
        for (int x = -8; x <= 8; ++x) {
            for (int y = -8; y <= 8; ++y) {
                if ((x == 0 && y == 0) || x * x + y * y > 64) continue;
                double re = 0, im = 0;
                for (const Orientation g : all_orientations()) {
                    for (const glm::dvec2 p : at) {
                        const glm::dvec2 q = apply(g, p) / side;
                        re += std::cos(2 * std::numbers::pi * (x * q.x + y * q.y)) / 8;
                        im += std::sin(2 * std::numbers::pi * (x * q.x + y * q.y)) / 8;
                    }
                }
                CHECK(std::abs(im) < 1e-9);
                const double height = re * re;  // 16 / N = 1
                best = std::max(best, height);
                if (0 <= x && x <= y) penalty += 0.5 * std::pow(std::max(0.0, height - 3), 2);
            }
        }
        return std::pair(best, penalty);
    };
    CoherentPeaks peaks(16, 0.5, 3);
    peaks.reset(positions);
    const auto [height, penalty] = highest(positions);
    CHECK(peaks.highest() == doctest::Approx(height).epsilon(1e-5));
    CHECK(peaks.penalty() == doctest::Approx(penalty).epsilon(1e-5));

    // A small move changes only what is watched.
    std::vector<glm::dvec2> moved = positions;
    moved[3] += glm::dvec2(0.02, -0.01);
    const std::vector<CoherentPeaks::Move> moves{{positions[3], moved[3]}};
    const double change = peaks.try_moves(moves);
    CHECK(penalty + change == doctest::Approx(highest(moved).second).epsilon(1e-3));
    peaks.take();
    CHECK(peaks.penalty() == doctest::Approx(penalty + change));
}
