#pragma once
// Long work that Ctrl+C, SIGTERM, a closed terminal or a time limit asks to stop rather than ends.

#include <chrono>
#include <optional>
#include <stop_token>
#include <thread>

namespace dapple {

/// While it lives, the first Ctrl+C or SIGTERM requests a stop; the second ends the program as always.
/// SIGHUP, from a terminal that is closed, requests a stop too, and from then on never ends the program, so
/// that it can save what it has. Only one may live at a time.
class StopOnInterrupt {
 public:
    /// Without a limit, only signals stop.
    explicit StopOnInterrupt(std::optional<std::chrono::duration<double>> limit = {});
    StopOnInterrupt(const StopOnInterrupt&) = delete;
    StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;
    ~StopOnInterrupt();

    std::stop_token token() const { return source_.get_token(); }
    /// Whether a signal has come.
    static bool interrupted();

 private:
    std::stop_source source_;
    std::jthread watch_;  // looks at the clock and at what the signal handler has left
};

}  // namespace dapple
