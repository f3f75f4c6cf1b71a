#pragma once
// What Ctrl+C, SIGTERM and SIGHUP (a terminal that closes) do, in one place. As always they end the program;
// but first they remove files that are half written, and where long work has asked for it, the first of them
// only stops that work, which then keeps the best it has. What was switched off before, as nohup does with
// SIGHUP and a shell with Ctrl+C for what runs in the background, stays off.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <thread>

namespace dapple {

/// More than pictures can be drawn at a time, each with a file under way and perhaps one for a moment.
inline constexpr std::size_t kMostFilesUnderWay = 600;

/// A file that is gone at the end of the scope, or when one of those signals ends the program before.
class RemovedOnSignal {
 public:
    /// The file is not made by this. Throws std::runtime_error if the path is too long, or if more than
    /// kMostFilesUnderWay are.
    explicit RemovedOnSignal(const std::filesystem::path& path);
    RemovedOnSignal(const RemovedOnSignal&) = delete;
    RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;
    ~RemovedOnSignal();

    const char* path() const;
    /// Makes the file and opens it to be read and written; -1 and errno if it cannot be, or if there is one.
    /// While a signal ends the program, nothing is made any more: neither this nor the destructor returns.
    int make() const;
    /// What has this name from now on stays.
    void keep();

 private:
    std::size_t slot_;
};

/// While it lives, a Ctrl+C that ends the program says on the standard error that files are as before.
class ToldWhenStopped {
 public:
    ToldWhenStopped();
    ToldWhenStopped(const ToldWhenStopped&) = delete;
    ToldWhenStopped& operator=(const ToldWhenStopped&) = delete;
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

/// While one lives, two signals about writing are errors of write() instead, so that a sentence can say them:
/// a pipe that nobody reads any more (SIGPIPE), and a file over the size that is allowed (SIGXFSZ).
class WriteErrorsInsteadOfSignals {
 public:
    WriteErrorsInsteadOfSignals();
    WriteErrorsInsteadOfSignals(const WriteErrorsInsteadOfSignals&) = delete;
    WriteErrorsInsteadOfSignals& operator=(const WriteErrorsInsteadOfSignals&) = delete;
    ~WriteErrorsInsteadOfSignals();
};

}  // namespace dapple
