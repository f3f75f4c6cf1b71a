#pragma once
// How many frames a second the window draws.

#include <chrono>

namespace dapple {

/// Frames per second while frames follow each other; a rest in between does not count.
class FrameRate {
 public:
    using Clock = std::chrono::steady_clock;

    void frame(Clock::time_point now) {
        std::chrono::duration<double> passed = now - last_;
        last_ = now;
        if (passed.count() <= 0 || passed.count() > kRest) return;
        seconds_ = seconds_ > 0 ? seconds_ + 0.1 * (passed.count() - seconds_) : passed.count();
    }
    double per_second() const { return seconds_ > 0 ? 1 / seconds_ : 0; }

 private:
    static constexpr double kRest = 0.5;
    Clock::time_point last_{};
    double seconds_ = 0;
};

}  // namespace dapple
