#include "lab/search/rule_search.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace dapple {

RelinkResult search_rules(const RelinkSettings& settings, std::span<const Rule> rules, int runs) {
    const std::uint64_t moves = settings.moves * static_cast<std::uint64_t>(runs);
    const auto rounds = static_cast<std::uint64_t>(std::bit_width(rules.size()) - 1);
    const double begun = settings.clock ? settings.clock() : 0;
    // Without a clock there is always time, all the seconds of none.
    const auto seconds_left = [&] {
        return settings.clock ? settings.seconds - (settings.clock() - begun) : settings.seconds;
    };
    const auto in_time = [&] { return !settings.clock || seconds_left() > 0; };
    RelinkSettings own = settings;
    RelinkResult best;
    const auto keep_better = [&](RelinkResult& found) {
        if (best.tile.size() == 0 || found.energy < best.energy) best = std::move(found);
    };
    std::vector<Rule> left(rules.begin(), rules.end());
    while (left.size() > 1 && !settings.stop.stop_requested() && in_time()) {
        own.moves = std::max<std::uint64_t>(1, moves / 2 / rounds / left.size());
        own.seconds = std::min(settings.seconds / 2 / static_cast<double>(rounds), seconds_left());
        std::vector<RelinkSettings> trials(left.size(), own);
        for (std::size_t k = 0; k < left.size(); ++k) trials[k].rule = left[k];
        std::vector<RelinkResult> results = relink_searches(std::move(trials));
        left.resize(left.size() / 2);
        for (std::size_t k = 0; k < left.size(); ++k) left[k] = results[k].tile.rule;
        keep_better(results.front());
    }
    if (best.tile.size() > 0 && !in_time()) return best;
    own.rule = left.front();
    own.moves = std::max<std::uint64_t>(1, settings.moves - settings.moves / 2);
    own.seconds = seconds_left();
    keep_better(relink_searches(own, runs).front());
    return best;
}

}  // namespace dapple
