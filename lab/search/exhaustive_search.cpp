#include "lab/search/exhaustive_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cassert>
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

// One pass, shared by its threads.
class Pass {
 public:
    Pass(SearchState& state, const SearchControl& control)
        : state_(state),
          control_(control),
          floor_(floor_of_pass(state.pass)),
          bound_(state.points, floor_),
          endings_(WordTree(state.points).endings(std::min(kEndingLength, state.points), bound_)) {
        if (state.done.empty()) state.done.resize(endings_.size());
        if (state.done.size() != endings_.size()) {
            throw std::runtime_error(
                fmt::format("the saved search has {} parts where pass {} of {} points has {}; start it anew",
                            state.done.size(), state.pass, state.points, endings_.size()));
        }
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
        if (static_cast<std::size_t>(done_) < endings_.size()) return;
        const auto top = static_cast<std::size_t>(state_.top);
        state_.finished = floor_ == 0 || state_.found.size() >= top;
        if (!state_.finished) ++state_.pass;
        state_.done.clear();
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
        std::vector<FoundTile>& found = state_.found;
        const auto top = static_cast<std::size_t>(state_.top);
        if (found.size() == top && radius < found.back().relative_radius) return;
        FoundTile tile{smallest_symmetric_word(word), radius};
        const auto at = std::lower_bound(found.begin(), found.end(), tile, better);
        if (at != found.end() && *at == tile) return;
        found.insert(at, std::move(tile));
        if (found.size() > top) found.pop_back();
        raise_bound();
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

}  // namespace dapple
