#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <vector>

#include "lab/search/criteria.h"
#include "lab/search/relink_search.h"
#include "lab/search/rule_search.h"
#include "lab/search/rules.h"
#include "lab/search/tile_marks.h"
#include "tests/tile_words.h"

using namespace dapple;

namespace {

Rule rule_of(int h0, int h1, int h2, int h3) {
    Rule rule;
    const std::array digits{h0, h1, h2, h3};
    for (std::size_t q = 0; q < 4; ++q) rule.child[q].index = static_cast<std::uint8_t>(digits[q]);
    return rule;
}

std::vector<Rule> all_rules() {
    std::vector<Rule> rules;
    for (int d = 0; d < 4096; ++d) rules.push_back(rule_of(d / 512, d / 64 % 8, d / 8 % 8, d % 8));
    return rules;
}

double highest_coincidence(const Rule& rule, int lags) {
    const std::vector<double> at_lags = orientation_coincidence(rule, lags);
    return *std::ranges::max_element(at_lags);
}

// The first of each kind of rules that are one up to symmetry, found one by one.
std::vector<Rule> one_of_each_kind() {
    std::set<std::string> seen;
    std::vector<Rule> kinds;
    for (const Rule& rule : all_rules()) {
        if (seen.contains(text_of(rule))) continue;
        kinds.push_back(rule);
        for (const Orientation g : all_orientations()) seen.insert(text_of(turned(rule, g)));
    }
    return kinds;
}

bool lies_in(BinaryPoint p, const Tile& tile) {
    return std::ranges::any_of(tile.points, [&](BinaryPoint q) {
        // The last digits of what repeats for ever are rounded.
        return p.x >> 8 == q.x >> 8 && p.y >> 8 == q.y >> 8;
    });
}

RelinkSettings small_search() {
    RelinkSettings settings;
    settings.points = 16;
    settings.moves = 3000;
    settings.seed = 5;
    return settings;
}

}  // namespace

TEST_CASE("a turned tile is a tile of the turned rule") {
    const Tile tile = make_tile(rule_of(3, 7, 6, 0), {"0301213303211022"});
    for (const Orientation g : all_orientations()) {
        std::vector<BinaryPoint> points;
        for (const BinaryPoint p : tile.points) points.push_back(apply(g, p));
        const Rule rule = turned(tile.rule, g);
        const Tile again = make_tile(rule, words_of(points, rule));
        REQUIRE(again.size() == tile.size());
        for (const BinaryPoint p : points) CHECK(lies_in(p, again));
    }
}

TEST_CASE("there are as many rules distinct up to symmetry as Burnside counts") {
    // The mean number of rules that a symmetry leaves as they are.
    int unmoved = 0;
    for (const Orientation g : all_orientations())
        for (const Rule& rule : all_rules()) unmoved += turned(rule, g) == rule;
    CHECK(unmoved % 8 == 0);
    // By hand: 4096 + 2 x 8 (quarter turns) + 64 (half turn) + 2 x 64 (axes) + 2 x 128 (diagonals).
    CHECK(unmoved == 4560);

    CHECK(static_cast<int>(one_of_each_kind().size()) == unmoved / 8);
}

TEST_CASE("symmetric rules turn equally many tiles alike") {
    for (const Rule& rule : {rule_of(3, 7, 6, 0), rule_of(0, 1, 0, 0), rule_of(5, 2, 2, 4)}) {
        const std::vector<double> expected = orientation_coincidence(rule, 6);
        for (const Orientation g : all_orientations()) {
            const std::vector<double> found = orientation_coincidence(turned(rule, g), 6);
            for (std::size_t k = 0; k < expected.size(); ++k)
                CHECK(found[k] == doctest::Approx(expected[k]).epsilon(1e-9));
        }
    }
}

TEST_CASE("the best rules are those with the lowest coincidence of all") {
    const std::vector<RuleMarks> best = best_rules(12);
    REQUIRE(best.size() == 12);
    std::set<std::string> seen;
    for (std::size_t k = 0; k < best.size(); ++k) {
        const std::vector<double> at_lags = orientation_coincidence(best[k].rule, 64);
        const auto highest = std::ranges::max_element(at_lags);
        CHECK(best[k].coincidence == *highest);
        CHECK(best[k].lag == highest - at_lags.begin() + 1);
        CHECK(best[k].mean <= best[k].coincidence);
        if (k > 0) CHECK(best[k].coincidence >= best[k - 1].coincidence - 1e-9);
        for (const Orientation g : all_orientations()) seen.insert(text_of(turned(best[k].rule, g)));
    }
    CHECK(seen.contains("3760"));
    CHECK(seen.contains("7241"));
    CHECK(best.front().coincidence < highest_coincidence(aperiodic_rule(), 64));
    // Every other rule is above them at one of a few lags already, so above them at one of all.
    for (const Rule& rule : one_of_each_kind()) {
        if (seen.contains(text_of(rule))) continue;
        if (highest_coincidence(rule, 3) > best.back().coincidence) continue;
        CHECK(highest_coincidence(rule, 64) >= best.back().coincidence - 1e-9);
    }
}

TEST_CASE("a search over rules finds the same tile again, on however many cores") {
    const std::vector<Rule> rules{rule_of(0, 0, 0, 0), aperiodic_rule(), rule_of(7, 2, 4, 1),
                                  rule_of(2, 4, 5, 6), rule_of(0, 3, 7, 4)};
    const RelinkResult found = search_rules(small_search(), rules, 2);
    CHECK(found.tile.size() == 16);
    CHECK(std::ranges::find(rules, found.tile.rule) != rules.end());
    tbb::task_arena one_core(1);
    const RelinkResult again = one_core.execute([&] { return search_rules(small_search(), rules, 2); });
    CHECK(again.tile.rule == found.tile.rule);
    CHECK(again.tile.words == found.tile.words);
    CHECK(again.energy == found.energy);
}

TEST_CASE("a search over rules tries as many moves as were asked for, half of them to choose the rule") {
    const std::vector<Rule> rules{aperiodic_rule(), rule_of(7, 2, 4, 1), rule_of(2, 4, 5, 6),
                                  rule_of(0, 3, 7, 4)};
    RelinkSettings settings = small_search();
    std::mutex mutex;
    std::uint64_t tried = 0, longest = 0;
    std::set<std::string> seen;
    double best = 1e9;
    settings.progress = [&](const RelinkProgress& progress) {
        const std::lock_guard lock(mutex);
        tried += progress.new_moves;
        longest = std::max(longest, progress.moves);
        seen.insert(text_of(progress.rule));
        best = std::min(best, progress.best);
    };
    const RelinkResult found = search_rules(settings, rules, 2);
    CHECK(tried <= 2 * settings.moves);
    CHECK(tried >= 2 * settings.moves - 8);
    CHECK(longest == settings.moves / 2);
    CHECK(seen.size() == 4);
    CHECK(found.energy == best);
    CHECK(relink_energy(found.tile, settings.shape) <= found.energy + 1e-6);
}

TEST_CASE("a search over rules that is stopped while it chooses returns the best so far") {
    RelinkSettings settings = small_search();
    settings.moves = 1'000'000'000'000;
    std::stop_source source;
    settings.stop = source.get_token();
    settings.progress = [&](const RelinkProgress&) { source.request_stop(); };
    const std::vector<Rule> rules{aperiodic_rule(), rule_of(7, 2, 4, 1), rule_of(2, 4, 5, 6)};
    const RelinkResult found = search_rules(settings, rules, 1);
    CHECK(found.tile.size() == 16);
    const Tile start = make_tile(found.tile.rule, even_words(16, settings.seed));
    CHECK(found.energy < relink_energy(start, settings.shape));
}
