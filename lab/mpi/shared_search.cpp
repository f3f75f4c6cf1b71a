#include "lab/mpi/shared_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <map>
#include <optional>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lab/mpi/messages.h"
#include "lab/search/identity_word.h"

namespace dapple {
namespace {

// From rank 0:  "search POINTS TOP PASS RADIUS PART PART ...", "stop" to whoever searches, or "end".
// To rank 0:    "ready", or "found PASS DONE WORD WORD ...": so many of the parts, the first ones, are done.

constexpr const char *kStop = "stop", *kEnd = "end";
// A rank tells what it has after so long, so that the others learn of it and little is lost if it is killed;
// and gets no more parts at once than these, and than half of its share of those that are left.
constexpr std::chrono::milliseconds kTells{500};
constexpr std::size_t kMostParts = 256;

class Distribution {
 public:
    Distribution(SearchState& state, const SearchControl& control) : state_(state), control_(control) {}

    void run() {
        while (!state_.finished && !control_.stop.stop_requested()) {
            if (!pass_) prepare_pass();
            if (!pass_) continue;
            hand_out();
            if (const auto message = message_there())
                take(*message);
            else
                wait_a_moment();
        }
        for (const auto& [rank, parts] : at_work_) send_text(rank, kStop);
        while (!at_work_.empty()) take(next_message());
    }

 private:
    void prepare_pass() {
        pass_.emplace(state_);
        number_ = state_.pass;
        begin_pass(state_, pass_->parts());
        todo_.clear();
        for (std::size_t i = 0; i < state_.done.size(); ++i)
            if (const std::size_t part = pass_->in_turn(i); !state_.done[part]) todo_.push_back(part);
        if (state_.pass != number_ || state_.finished) pass_.reset();
    }

    void hand_out() {
        while (!idle_.empty() && !todo_.empty()) {
            const int rank = idle_.front();
            idle_.pop_front();
            const auto share = todo_.size() / (2 * static_cast<std::size_t>(ranks_in_all()));
            std::string task = fmt::format("search {} {} {} {:a}", state_.points, state_.top, state_.pass,
                                           radius_wanted(state_));
            std::vector<std::size_t>& parts = at_work_[rank];
            for (std::size_t i = std::clamp<std::size_t>(share, 1, kMostParts); i > 0; --i) {
                parts.push_back(todo_.front());
                todo_.pop_front();
                task += fmt::format(" {}", parts.back());
            }
            send_text(rank, task);
        }
    }

    void take(const Message& message) {
        idle_.push_back(message.from);
        std::istringstream in(message.text);
        std::string kind, word;
        int pass = 0;
        std::size_t done = 0;
        in >> kind >> pass >> done;
        if (kind != "found") return;
        const std::vector<std::size_t> parts = std::exchange(at_work_[message.from], {});
        at_work_.erase(message.from);
        todo_.insert(todo_.begin(), parts.begin() + static_cast<std::ptrdiff_t>(done), parts.end());
        std::vector<FoundTile> found;
        while (in >> word) found.push_back({word, relative_radius(word)});
        for (std::size_t i = 0; i < done; ++i) take_part(state_, parts[i], std::exchange(found, {}));
        if (control_.on_progress) control_.on_progress({pass_->floor(), share_done(), state_});
        if (state_.pass != number_ || state_.finished) pass_.reset();
    }

    double share_done() const {
        std::size_t done = 0;
        for (const bool each : state_.done) done += each;
        return state_.done.empty() ? 1 : static_cast<double>(done) / static_cast<double>(state_.done.size());
    }

    SearchState& state_;
    const SearchControl& control_;
    std::optional<PartSearch> pass_;
    int number_ = 0;
    std::deque<std::size_t> todo_;  // parts of the pass that nobody has
    std::deque<int> idle_;          // ranks that wait for some
    std::map<int, std::vector<std::size_t>> at_work_;
};

}  // namespace

SearchState continue_on_ranks(SearchState state, const SearchControl& control) {
    if (ranks_in_all() == 1) return continue_exhaustive_search(std::move(state), control);
    Distribution(state, control).run();
    return state;
}

void search_for_rank_0() {
    std::optional<PartSearch> pass;
    SearchState of;  // that pass's
    // What ends a job is sent to all ranks: rank 0 saves the search and tells the others.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    send_text(0, "ready");
    while (true) {
        const std::string task = next_message().text;
        if (task == kEnd) return;
        if (task == kStop) continue;  // it came when all was told
        std::istringstream in(task);
        std::string kind, radius;
        SearchState state;
        in >> kind >> state.points >> state.top >> state.pass >> radius;
        std::vector<std::size_t> parts;
        for (std::size_t part = 0; in >> part;) parts.push_back(part);
        if (!pass || !(state == of)) pass.emplace(of = state);
        std::vector<FoundTile> found;
        std::size_t searched = 0;
        std::atomic<bool> done = false;
        std::jthread searching([&](const std::stop_token& stop) {
            const auto begin = std::chrono::steady_clock::now();
            while (searched < parts.size() && std::chrono::steady_clock::now() - begin < kTells) {
                for (FoundTile& tile :
                     pass->search(parts[searched], std::strtod(radius.c_str(), nullptr), stop))
                    found.push_back(std::move(tile));
                if (stop.stop_requested()) break;
                ++searched;
            }
            done = true;
        });
        // Nothing else comes while it searches.
        while (!done) {
            if (message_there()) searching.request_stop();
            wait_a_moment();
        }
        searching.join();
        std::string answer = fmt::format("found {} {}", state.pass, searched);
        for (const FoundTile& tile : found) answer += ' ' + tile.word;
        send_text(0, answer);
    }
}

void end_ranks() {
    for (int rank = 1; rank < ranks_in_all(); ++rank) send_text(rank, kEnd);
}

}  // namespace dapple
