#include "core/tile/rule_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace dapple {

namespace {

std::vector<RelinkResult> searched(const RelinkSettings& settings, std::span<const Rule> rules) {
    std::vector<RelinkResult> results(rules.size());
    tbb::parallel_for(std::size_t{0}, rules.size(), [&](std::size_t k) {
        RelinkSettings own = settings;
        own.rule = rules[k];
        results[k] = relink_search(own);
    });
    std::ranges::stable_sort(results, {}, &RelinkResult::energy);
    return results;
}

}  // namespace

RelinkResult search_rules(const RelinkSettings& settings, std::span<const Rule> rules, int runs) {
    const std::uint64_t moves = settings.moves * static_cast<std::uint64_t>(runs);
    const auto rounds = static_cast<std::uint64_t>(std::bit_width(rules.size()) - 1);
    RelinkSettings own = settings;
    RelinkResult best;
    const auto keep_better = [&](RelinkResult& found) {
        if (best.tile.size() == 0 || found.energy < best.energy) best = std::move(found);
    };
    std::vector<Rule> left(rules.begin(), rules.end());
    while (left.size() > 1 && !settings.stop.stop_requested()) {
        own.moves = std::max<std::uint64_t>(1, moves / 2 / rounds / left.size());
        std::vector<RelinkResult> results = searched(own, left);
        left.resize(left.size() / 2);
        for (std::size_t k = 0; k < left.size(); ++k) left[k] = results[k].tile.rule;
        keep_better(results.front());
    }
    own.rule = left.front();
    own.moves = std::max<std::uint64_t>(1, settings.moves - settings.moves / 2);
    keep_better(relink_searches(own, runs).front());
    return best;
}

}  // namespace dapple
