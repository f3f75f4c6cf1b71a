#include "lab/search/kind_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/tile/random.h"
#include "lab/search/criteria.h"
#include "lab/search/kind_links.h"

namespace dapple {

namespace {

constexpr std::uint64_t kMeltingMoves = 20;           // a point, before it counts that kinds differ
constexpr double kMelting = 1.5;                      // of the start temperature, meanwhile
constexpr std::uint64_t kMovesBetweenRefreshes = 32;  // a point
constexpr std::uint64_t kMovesBetweenLooks = 4096;    // at the clock, and whether to stop

NextKinds random_substitution(int kinds, Random& random) {
    NextKinds next(static_cast<std::size_t>(kinds));
    std::vector<std::uint16_t> order(next.size());
    for (std::size_t q = 0; q < 4; ++q) {
        std::iota(order.begin(), order.end(), std::uint16_t{0});
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
        for (std::size_t k = 0; k < next.size(); ++k) next[k][q] = order[k];
    }
    return next;
}

}  // namespace

NextKinds mixed_kinds(int kinds, std::uint64_t seed) {
    if (kinds < 2 || kinds > static_cast<int>(kMaxKinds)) {
        throw std::runtime_error(
            fmt::format("{} kinds cannot be searched for; use 2 to {}", kinds, kMaxKinds));
    }
    constexpr int kLags = 8;       // what repeats mostly does so nearby
    constexpr int kDivisions = 3;  // of a page; which it starts with hardly matters to a finer one
    const int tries = std::clamp(50'000 / (kinds * kinds), 4, 500);
    Random random(seed);
    NextKinds best;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
        NextKinds next = random_substitution(kinds, random);
        const double highest =
            std::max(std::ranges::max(kind_coincidence(next, kLags)), page_coincidence(next, kDivisions));
        if (highest >= lowest) continue;
        lowest = highest;
        best = std::move(next);
    }
    return best;
}

Island island_of(const Tile& tile, double energy) {
    Island island{.energy = energy, .successors = tile.successor};
    for (const BinaryPoint point : tile.points) island.letters += static_cast<char>('0' + quadrant_of(point));
    return island;
}

KindSearchResult kind_search(const KindSearchSettings& settings) {
    const Tile& start = settings.start;
    if (start.kinds() > 1 || start.rule != Rule{})
        throw std::runtime_error("the search for several kinds starts from a tile of one that is not turned");
    const double begun = settings.clock ? settings.clock() : 0;
    const NextKinds next = mixed_kinds(settings.kinds, settings.seed);
    std::string letters;
    std::vector<std::uint32_t> successor;
    for (const auto& children : next) {
        for (std::size_t i = 0; i < start.size(); ++i) {
            const auto q = static_cast<std::size_t>(quadrant_of(start.points[i]));
            letters += static_cast<char>('0' + q);
            successor.push_back(static_cast<std::uint32_t>(children[q] * start.size() + start.successor[i]));
        }
    }
    KindLinks links(next, letters, successor, settings.shape);
    Random random(settings.seed + (static_cast<std::uint64_t>(settings.island) << 32));
    KindSearchProgress progress;
    const auto count = static_cast<double>(links.size());
    const std::uint64_t refresh_after = kMovesBetweenRefreshes * links.size();
    std::uint64_t taken = 0, since_refresh = 0;
    bool apart = false, stops = false;
    int exchanges = 0;
    const auto exchange = [&] {
        ++exchanges;
        links.refresh();
        const Island best = settings.best(
            {links.energy() / count, letters, links.successors(), settings.stop.stop_requested()});
        stops = best.stops;
        if (best.successors == links.successors()) return;
        links = KindLinks(next, best.letters, best.successors, settings.shape);
        apart = apart && links.set_apart(settings.apart);
    };
    double done = settings.clock || settings.moves > 0 ? 0 : 1;  // share of the search
    while (done < 1 && !stops) {
        if (settings.stop.stop_requested()) {
            if (settings.best) exchange();
            break;
        }
        double temperature = settings.start_temperature *
                             std::pow(settings.end_temperature / settings.start_temperature, done);
        if (!apart) temperature = kMelting * settings.start_temperature;
        std::uint64_t round = std::min(kMovesBetweenLooks, refresh_after - since_refresh);
        if (!settings.clock) round = std::min(round, settings.moves - progress.moves);
        for (std::uint64_t k = 0; k < round; ++k)
            taken += links.step(random, temperature, settings.move_radius);
        progress.moves += round;
        since_refresh += round;
        if (settings.clock) {
            const double elapsed = settings.clock() - begun;
            done = elapsed < settings.seconds ? elapsed / settings.seconds : 1;
        } else {
            done = static_cast<double>(progress.moves) / static_cast<double>(settings.moves);
        }
        while (settings.best && !stops && exchanges < static_cast<int>(done * kExchanges)) exchange();
        if (!apart && progress.moves >= kMeltingMoves * links.size()) apart = links.set_apart(settings.apart);
        if (since_refresh < refresh_after) continue;
        links.refresh();
        progress.energy = links.energy() / count;
        progress.acceptance = static_cast<double>(std::exchange(taken, 0)) /
                              static_cast<double>(std::exchange(since_refresh, 0));
        if (settings.progress) settings.progress(progress);
    }
    links.refresh();
    return {make_tile(Rule{}, next, letters, links.successors()), links.energy() / count, progress.moves};
}

}  // namespace dapple
