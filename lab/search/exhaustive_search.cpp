#include "lab/search/exhaustive_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "lab/search/identity_word.h"
#include "lab/search/word_tree.h"

namespace dapple {

namespace {

// Some hundreds to some thousands of parts a pass.
constexpr int kEndingLength = 10;

double floor_of_pass(int pass) {
    return std::max(0.0, 0.97 - 0.03 * pass);
}

bool better(const FoundTile& a, const FoundTile& b) {
    return a.relative_radius != b.relative_radius ? a.relative_radius > b.relative_radius : a.word < b.word;
}

// Neighbouring endings are alike in work and the first ones heavy: a stride near the golden ratio spreads
// them, so that the share of parts done tells the share of time.
std::size_t stride_for(std::size_t parts) {
    auto stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(parts)));
    while (std::gcd(stride, parts) != 1) ++stride;
    return stride;
}

// False if it is not among the best, or there already.
bool insert(std::vector<FoundTile>& found, FoundTile tile, std::size_t top) {
    const auto at = std::lower_bound(found.begin(), found.end(), tile, better);
    if (at != found.end() && *at == tile) return false;
    if (found.size() == top && at == found.end()) return false;
    found.insert(at, std::move(tile));
    if (found.size() > top) found.pop_back();
    return true;
}

std::vector<std::string> endings_of(int points, const RadiusBound& bound) {
    return WordTree(points).endings(std::min(kEndingLength, points), bound);
}

void check_parts(const SearchState& state, std::size_t parts) {
    if (state.done.empty() || state.done.size() == parts) return;
    throw std::runtime_error(
        fmt::format("the saved search has {} parts where pass {} of {} points has {}; start it anew",
                    state.done.size(), state.pass, state.points, parts));
}

void end_pass(SearchState& state) {
    state.finished =
        floor_of_pass(state.pass) == 0 || state.found.size() >= static_cast<std::size_t>(state.top);
    if (!state.finished) ++state.pass;
    state.done.clear();
}

// One pass, shared by its threads.
class Pass {
 public:
    Pass(SearchState& state, const SearchControl& control)
        : state_(state),
          control_(control),
          floor_(floor_of_pass(state.pass)),
          bound_(state.points, floor_),
          endings_(endings_of(state.points, bound_)) {
        check_parts(state, endings_.size());
        state.done.resize(endings_.size());
        done_ = std::count(state.done.begin(), state.done.end(), true);
        raise_bound();
    }

    void run() {
        const int wanted =
            control_.threads > 0 ? control_.threads : static_cast<int>(std::thread::hardware_concurrency());
        const auto threads = std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1,
                                                     std::max<std::size_t>(endings_.size(), 1));
        {
            std::vector<std::jthread> others;
            for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
            work();
        }
        if (static_cast<std::size_t>(done_) == endings_.size()) end_pass(state_);
    }

 private:
    void work() {
        WordTree tree(state_.points);
        const std::size_t stride = stride_for(endings_.size());
        for (std::size_t i = next_++; i < endings_.size() && !control_.stop.stop_requested(); i = next_++) {
            const std::size_t part = i * stride % endings_.size();
            {
                const std::lock_guard lock(mutex_);
                if (state_.done[part]) continue;
            }
            const bool finished = tree.complete(endings_[part], bound_, control_.stop,
                                                [this](const std::string& word) { offer(word); });
            if (!finished) return;
            const std::lock_guard lock(mutex_);
            state_.done[part] = true;
            ++done_;
            if (control_.on_progress) {
                const double fraction = static_cast<double>(done_) / static_cast<double>(endings_.size());
                control_.on_progress({floor_, fraction, state_});
            }
        }
    }

    void offer(const std::string& word) {
        const double radius = relative_radius(word);
        if (radius < floor_ || radius == 0) return;
        const std::lock_guard lock(mutex_);
        const std::vector<FoundTile>& found = state_.found;
        const auto top = static_cast<std::size_t>(state_.top);
        if (found.size() == top && radius < found.back().relative_radius) return;
        if (insert(state_.found, {smallest_symmetric_word(word), radius}, top)) raise_bound();
    }

    void raise_bound() {
        if (state_.found.size() == static_cast<std::size_t>(state_.top))
            bound_.raise_to(state_.found.back().relative_radius);
    }

    SearchState& state_;
    const SearchControl& control_;
    const double floor_;
    RadiusBound bound_;
    const std::vector<std::string> endings_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;  // for the state and done_
    std::ptrdiff_t done_ = 0;
};

}  // namespace

SearchState start_exhaustive_search(int points, int top) {
    if (points < 4 || points > kMaxIdentityWord || points % 4 != 0) {
        throw std::runtime_error(fmt::format(
            "tiles of {} points cannot be searched for exhaustively; use a multiple of 4 from 4 to {}",
            points, kMaxIdentityWord));
    }
    if (top < 1) throw std::runtime_error(fmt::format("the best {} tiles are none; ask for at least 1", top));
    SearchState state;
    state.points = points;
    state.top = top;
    return state;
}

double proven_radius(const SearchState& state) {
    if (state.finished) {
        return state.found.size() == static_cast<std::size_t>(state.top) ? state.found.back().relative_radius
                                                                         : 0.0;
    }
    return state.pass == 0 ? std::numeric_limits<double>::infinity() : floor_of_pass(state.pass - 1);
}

SearchState continue_exhaustive_search(SearchState state, const SearchControl& control) {
    while (!state.finished && !control.stop.stop_requested()) Pass(state, control).run();
    return state;
}

PartSearch::PartSearch(const SearchState& state)
    : points_(state.points), top_(static_cast<std::size_t>(state.top)), floor_(floor_of_pass(state.pass)) {
    endings_ = endings_of(points_, RadiusBound(points_, floor_));
    check_parts(state, endings_.size());
}

std::size_t PartSearch::in_turn(std::size_t i) const {
    return i * stride_for(endings_.size()) % endings_.size();
}

std::vector<FoundTile> PartSearch::search(std::size_t part, double radius,
                                          const std::stop_token& stop) const {
    RadiusBound bound(points_, std::max(floor_, radius));
    std::vector<FoundTile> found;
    WordTree tree(points_);
    tree.complete(endings_[part], bound, stop, [&](const std::string& word) {
        const double there = relative_radius(word);
        if (there < std::max(floor_, radius) || there == 0) return;
        if (insert(found, {smallest_symmetric_word(word), there}, top_) && found.size() == top_)
            bound.raise_to(found.back().relative_radius);
    });
    return found;
}

double radius_wanted(const SearchState& state) {
    const bool full = state.found.size() == static_cast<std::size_t>(state.top);
    return full ? state.found.back().relative_radius : floor_of_pass(state.pass);
}

void begin_pass(SearchState& state, std::size_t parts) {
    state.done.resize(parts);
    if (parts == 0) end_pass(state);
}

void take_part(SearchState& state, std::size_t part, std::vector<FoundTile> found) {
    state.done[part] = true;
    for (FoundTile& tile : found) insert(state.found, std::move(tile), static_cast<std::size_t>(state.top));
    if (std::ranges::find(state.done, false) == state.done.end()) end_pass(state);
}

SearchEstimate estimate_pass(int points, double floor, int probes, std::uint64_t seed) {
    const RadiusBound bound(points, floor);
    WordTree tree(points);
    Random random(seed);
    const std::vector<std::string> endings = endings_of(points, bound);
    // So many ways down each part; or, where there are more parts than ways, down parts drawn at random, each
    // of which stands for all.
    const std::size_t each = static_cast<std::size_t>(probes) / std::max<std::size_t>(endings.size(), 1);
    const bool all = each > 1;
    const std::size_t groups = endings.empty() ? 0 : all ? endings.size() : 1;
    const std::size_t ways = all ? each : static_cast<std::size_t>(probes);
    SearchEstimate estimate;
    double variance = 0;
    for (std::size_t group = 0; group < groups; ++group) {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < ways; ++i) {
            const std::size_t ending = all ? group : random.below(endings.size());
            const double words =
                tree.probe(endings[ending], bound, random) * static_cast<double>(all ? 1 : endings.size());
            sum += words;
            squares += words * words;
        }
        const auto count = static_cast<double>(ways);
        const double mean = sum / count;
        estimate.words += mean;
        if (ways > 1) variance += (squares / count - mean * mean) / (count - 1);
    }
    estimate.error = std::sqrt(std::max(variance, 0.0));
    return estimate;
}

double words_per_second(int points, double floor, double seconds) {
    using Clock = std::chrono::steady_clock;
    const RadiusBound bound(points, floor);
    const std::vector<std::string> endings = endings_of(points, bound);
    if (endings.empty()) return 0;
    WordTree tree(points);
    const auto begin = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    // A part may take hours.
    std::stop_source stop;
    const std::jthread clock([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        stop.request_stop();
    });
    for (std::size_t i = 0; !stop.stop_requested(); ++i)
        tree.complete(endings[i * stride_for(endings.size()) % endings.size()], bound, stop.get_token(),
                      [](const std::string&) {});
    return static_cast<double>(tree.steps()) / passed();
}

}  // namespace dapple
