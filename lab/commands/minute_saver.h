#pragma once
// Saves what a search of hours has found so far, as it goes.

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>

namespace dapple {

// Saves what a search has at once, and again once a minute, so that whatever happens to the machine no more
// than that is lost.
class MinuteSaver {
 public:
    void save(const std::function<void()>& write) {
        const auto now = Clock::now();
        if (last_ && now - *last_ < std::chrono::minutes(1)) return;
        last_ = now;
        try {
            write();
        } catch (const std::runtime_error&) {
            // A disk that is full now may not be so at the end, when what cannot be saved is told.
        }
    }

 private:
    using Clock = std::chrono::steady_clock;
    std::optional<Clock::time_point> last_;
};

}  // namespace dapple
