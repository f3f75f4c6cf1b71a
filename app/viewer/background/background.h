#pragma once
// Work in a thread of its own, one piece at a time: whoever has newer work waits until it is free and gives
// it the newest, so that nothing piles up while a slider moves. All that the window does in the background
// goes this way: what it came to, on the way and at the end, how far it is, that it is to stop, and what went
// wrong.

#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace dapple {

// The window's thread goes first: what works in the background has a lower priority, so that a window on a
// busy machine still answers. Linux alone tells threads apart in this; elsewhere nothing changes.

/// Does `work` in the thread that calls, which works in the background: lowers its priority for good, and
/// meanwhile that of the threads that oneTBB sends to help it. (Those that are started then have it from the
/// beginning.)
void behind_window(const std::function<void()>& work);

template <class Result>
class Background {
 public:
    using Clock = std::chrono::steady_clock;

    /// What the work has of the one who waits for it.
    class Task {
     public:
        Task(Background& owner, std::stop_token stop) : owner_(owner), stop_(std::move(stop)) {}

        const std::stop_token& stop() const { return stop_; }
        /// Passes on a result before the last.
        void publish(Result result) const {
            owner_.add(std::move(result));
            owner_.wake_();
        }
        /// How far the work is, 0..1; below 0: not known. Wakes whoever waits at each hundredth.
        void report_share(double share) const {
            // The window draws a frame for each step.
            const auto now = static_cast<float>(share);
            if (share < 1 && now < owner_.share_ + 0.01f) return;
            owner_.share_ = now;
            owner_.wake_();
        }
        /// The same for those who write it themselves, and wake nobody.
        std::atomic<float>& share() const { return owner_.share_; }

     private:
        Background& owner_;
        std::stop_token stop_;
    };

    /// Returns the last result, or nothing if it was stopped or has none.
    using Work = std::function<std::optional<Result>(const Task&)>;

    /// `wake` is called from the thread (of begin() if there is none) when there is a result, when the share
    /// has grown, and at the end, whatever that is. It throws nothing.
    explicit Background(std::function<void()> wake) : wake_(std::move(wake)) {}

    bool busy() const { return since().has_value(); }

    /// When the work that is under way began; none if none is.
    std::optional<Clock::time_point> since() const {
        std::scoped_lock lock(mutex_);
        return since_;
    }

    /// How far the work that is under way is, 0..1; none if it is not known.
    std::optional<float> share() const {
        const float share = share_;
        return busy() && share >= 0 ? std::optional(share) : std::nullopt;
    }

    /// Whether the work that is under way has passed on a result.
    bool has_published() const {
        std::scoped_lock lock(mutex_);
        return since_ && published_;
    }

    /// Not while busy. If the system has no thread for it, that is what the work threw.
    void begin(Work work) {
        if (thread_.joinable()) thread_.join();  // it may still be about to wake someone
        {
            std::scoped_lock lock(mutex_);
            assert(!since_);
            since_ = Clock::now();
            published_ = false;
            share_ = -1;
        }
        try {
            thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
                behind_window([&] { run(work, stop); });
            });
        } catch (const std::system_error& error) {
            end(std::make_exception_ptr(
                std::runtime_error("the system allows no further thread: " + error.code().message())));
            wake_();
        }
    }

    /// Gives up what is under way.
    void stop() { thread_.request_stop(); }

    /// Waits until there is a result or an error, none is to come, or that moment.
    void wait_until(Clock::time_point moment) {
        std::unique_lock lock(mutex_);
        changed_.wait_until(lock, moment, [this] { return !results_.empty() || error_ || !since_; });
    }

    /// The results one by one, in their order; then throws what the work threw, once.
    std::optional<Result> result() {
        std::scoped_lock lock(mutex_);
        if (results_.empty() && error_) std::rethrow_exception(std::exchange(error_, nullptr));
        std::optional<Result> first;
        if (!results_.empty()) {
            first.emplace(std::move(results_.front()));
            results_.pop_front();
        }
        return first;
    }

 private:
    // Whatever goes wrong, the program goes on and someone is told.
    void run(const Work& work, const std::stop_token& stop) {
        std::exception_ptr error;
        try {
            if (std::optional<Result> last = work(Task(*this, stop))) add(std::move(*last));
        } catch (...) {
            error = std::current_exception();
        }
        end(std::move(error));
        wake_();
    }

    void add(Result result) {
        std::scoped_lock lock(mutex_);
        results_.push_back(std::move(result));
        published_ = true;
        changed_.notify_all();
    }

    void end(std::exception_ptr error) {
        std::scoped_lock lock(mutex_);
        since_.reset();
        if (error) error_ = std::move(error);
        changed_.notify_all();
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Clock::time_point> since_;
    std::atomic<float> share_ = -1;
    bool published_ = false;
    std::deque<Result> results_;
    std::exception_ptr error_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dapple
