#pragma once
// How far a long work has come, on one line of the terminal.

#include <chrono>
#include <string_view>

namespace dapple {

/// Whether standard error is a terminal, with a person before it.
bool on_terminal();

/// Writes to standard error, if that is a terminal; else nothing. At most ten times a second. The line is
/// gone at the end.
///
///      [########------------]  41 %  about 12 s left, best 0.652788
class ProgressLine {
 public:
    ProgressLine();
    ProgressLine& operator=(ProgressLine&&) = delete;
    ~ProgressLine();

    /// fraction: 0..1 of the work since it was made or restarted, from which the time left is estimated.
    /// `piece` says what the estimate is for, if that is not all: "this pass: about 12 s left".
    void show(double fraction, std::string_view text, std::string_view piece = {});

    /// A new piece of work begins, at this fraction of it. What is shown next is shown at once.
    void restart(double fraction);

 private:
    using Clock = std::chrono::steady_clock;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), last_{};
    double start_fraction_ = 0;
};

}  // namespace dapple
