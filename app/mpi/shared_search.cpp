#include "app/mpi/shared_search.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/mpi/messages.h"
#include "lab/search/identity_word.h"

namespace dapple {
namespace {

// From rank 0:  "search POINTS TOP PASS PART RADIUS", "stop" to whoever searches, or "end".
// To rank 0:    "ready", "found PASS PART WORD WORD ...", or "stopped".

constexpr const char *kStop = "stop", *kEnd = "end";

std::string task_text(const SearchState& state, std::size_t part) {
    return fmt::format("search {} {} {} {} {:a}", state.points, state.top, state.pass, part,
                       radius_wanted(state));
}

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
        for (const int rank : at_work_) send_text(rank, kStop);
        while (!at_work_.empty()) take(next_message());
    }

 private:
    void prepare_pass() {
        pass_.emplace(state_);
        number_ = state_.pass;
        next_ = 0;
        begin_pass(state_, pass_->parts());
        if (state_.pass != number_ || state_.finished) pass_.reset();
    }

    void hand_out() {
        while (!idle_.empty() && next_ < pass_->parts()) {
            const std::size_t part = pass_->in_turn(next_++);
            if (state_.done[part]) continue;
            send_text(idle_.front(), task_text(state_, part));
            at_work_.insert(idle_.front());
            idle_.pop_front();
        }
    }

    void take(const Message& message) {
        idle_.push_back(message.from);
        std::istringstream in(message.text);
        std::string kind, word;
        int pass = 0;
        std::size_t part = 0;
        in >> kind >> pass >> part;
        at_work_.erase(message.from);
        if (kind != "found") return;
        std::vector<FoundTile> found;
        while (in >> word) found.push_back({word, relative_radius(word)});
        if (state_.finished || pass != number_ || !pass_) return;
        take_part(state_, part, std::move(found));
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
    std::size_t next_ = 0;
    std::deque<int> idle_;  // that wait for a part
    std::set<int> at_work_;
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
    send_text(0, "ready");
    while (true) {
        const std::string task = next_message().text;
        if (task == kEnd) return;
        if (task == kStop) continue;  // it came when all was told
        std::istringstream in(task);
        std::string kind, radius;
        SearchState state;
        std::size_t part = 0;
        in >> kind >> state.points >> state.top >> state.pass >> part >> radius;
        if (!pass || !(state == of)) pass.emplace(of = state);
        std::vector<FoundTile> found;
        std::atomic<bool> done = false;
        std::jthread searching([&](const std::stop_token& stop) {
            found = pass->search(part, std::strtod(radius.c_str(), nullptr), stop);
            done = true;
        });
        bool stopped = false;
        while (!done) {
            // Nothing else comes while it searches.
            if (message_there()) stopped = searching.request_stop();
            wait_a_moment();
        }
        searching.join();
        std::string answer = stopped ? "stopped" : fmt::format("found {} {}", state.pass, part);
        for (const FoundTile& tile : found)
            if (!stopped) answer += ' ' + tile.word;
        send_text(0, answer);
    }
}

void end_ranks() {
    for (int rank = 1; rank < ranks_in_all(); ++rank) send_text(rank, kEnd);
}

}  // namespace dapple
