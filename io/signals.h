#pragma once
// What Ctrl+C, SIGTERM and SIGHUP (a terminal that closes) do, in one place. As always they end the program;
// but where long work has asked for it, the first of them only stops that work, which then keeps the best it
// has. What was switched off before, as nohup does with SIGHUP and a shell with Ctrl+C for what runs in the
// background, stays off.

#include <chrono>
#include <optional>
#include <stop_token>
#include <thread>

namespace dapple {

/// While it lives, a Ctrl+C that ends the program says on the standard error that files are as before.
class ToldWhenStopped {
 public:
    ToldWhenStopped();
    ToldWhenStopped& operator=(ToldWhenStopped&&) = delete;
    ~ToldWhenStopped();
};

/// Long work that is asked to stop rather than ended. While it lives, the first Ctrl+C or SIGTERM requests a
/// stop, and leaves alone what is being saved; the second ends the program at once. SIGHUP requests a stop
/// too, and from then on never ends the program, so that it can save what it has. Only one may live at a
/// time.
class StopOnInterrupt {
 public:
    /// Without a time limit, only signals stop.
    explicit StopOnInterrupt(std::optional<std::chrono::duration<double>> limit = {});
    StopOnInterrupt& operator=(StopOnInterrupt&&) = delete;
    ~StopOnInterrupt();

    std::stop_token token() const { return source_.get_token(); }
    /// Whether a signal has come.
    static bool interrupted();

 private:
    std::stop_source source_;
    std::jthread watch_;  // looks at the clock and at what the signal handler has left
};

/// While one lives, two signals about writing are errors of write() instead, so that a sentence can say them:
/// a pipe that nobody reads any more (SIGPIPE), and a file over the size that is allowed (SIGXFSZ).
class WriteErrorsInsteadOfSignals {
 public:
    WriteErrorsInsteadOfSignals();
    WriteErrorsInsteadOfSignals& operator=(WriteErrorsInsteadOfSignals&&) = delete;
    ~WriteErrorsInsteadOfSignals();
};

}  // namespace dapple
