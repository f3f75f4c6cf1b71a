#pragma once
// Work in a thread of its own, one piece at a time: whoever has newer work waits until it is free and gives
// it the newest, so that nothing piles up while a slider moves.

#include <cassert>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace dapple {

template <class Result>
class Background {
 public:
    /// Nothing if stopped.
    using Work = std::function<std::optional<Result>(const std::stop_token&)>;

    /// `wake` is called from the thread when the work is done.
    explicit Background(std::function<void()> wake) : wake_(std::move(wake)) {}

    bool busy() const {
        std::scoped_lock lock(mutex_);
        return busy_;
    }

    /// Not while busy.
    void begin(Work work) {
        {
            std::scoped_lock lock(mutex_);
            assert(!busy_);
            busy_ = true;
            result_.reset();
            error_ = nullptr;
        }
        thread_ =
            std::jthread([this, work = std::move(work)](const std::stop_token& stop) { run(work, stop); });
    }

    /// Gives up what is under way.
    void stop() { thread_.request_stop(); }

    /// The result, once. Throws what the work threw, once.
    std::optional<Result> result() {
        std::scoped_lock lock(mutex_);
        if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
        return std::exchange(result_, std::nullopt);
    }

 private:
    void run(const Work& work, const std::stop_token& stop) {
        std::optional<Result> result;
        std::exception_ptr error;
        try {
            result = work(stop);
        } catch (...) {
            error = std::current_exception();
        }
        {
            std::scoped_lock lock(mutex_);
            busy_ = false;
            result_ = std::move(result);
            error_ = error;
        }
        wake_();
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    bool busy_ = false;
    std::optional<Result> result_;
    std::exception_ptr error_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dapple
