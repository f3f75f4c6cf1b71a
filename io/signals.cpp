#include "io/signals.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <string_view>

namespace dapple {
namespace {

// A signal handler is given nothing but the signal's number, so what it has to know is kept here.
std::atomic<bool> work_stops{false}, tells{false};
std::atomic<bool> signalled{false}, hung_up{false};  // since the last StopOnInterrupt began
static_assert(std::atomic<bool>::is_always_lock_free, "the handler may not wait");

// What signals did before, kept while any number of users want something else.
template <std::size_t N>
struct Replaced {
    std::array<int, N> signals;
    std::array<struct sigaction, N> former{};
    int users = 0;

    void begin(const struct sigaction& action) {
        if (users++ > 0) return;
        for (std::size_t i = 0; i < N; ++i) {
            ::sigaction(signals[i], nullptr, &former[i]);
            if (former[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);
        }
    }
    void end() {
        if (--users > 0) return;
        for (std::size_t i = 0; i < N; ++i) ::sigaction(signals[i], &former[i], nullptr);
    }
};
std::mutex users_mutex;
constexpr std::size_t kHangup = 2;
Replaced<3> endings{{SIGINT, SIGTERM, SIGHUP}};
Replaced<2> write_signals{{SIGPIPE, SIGXFSZ}};

struct sigaction ignoring() {
    struct sigaction action {};
    action.sa_handler = SIG_IGN;
    return action;
}

void end(int signal) {
    if (signal == SIGINT && tells) {
        // Over the line that shows progress, if there is one.
        constexpr std::string_view kSentence = "\r\033[Kdapple: stopped; unfinished files are as before\n";
        const std::string_view said =
            ::isatty(STDERR_FILENO) == 1 ? kSentence : kSentence.substr(kSentence.find('d'));
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, said.data(), said.size());
    }
    for (std::size_t i = 0; i < endings.signals.size(); ++i)
        if (endings.signals[i] == signal) ::sigaction(signal, &endings.former[i], nullptr);
    ::raise(signal);  // comes once the handler is left
}

void stop_or_end(int signal) {
    const int error = errno;
    bool ends = true;
    if (work_stops) {
        // A terminal that closes says so twice, the shell and the system one after the other.
        ends = signalled.exchange(true) && signal != SIGHUP;
        if (signal == SIGHUP) hung_up = true;
    }
    if (ends) end(signal);
    errno = error;
}

void watch_endings() {
    const std::lock_guard lock(users_mutex);
    struct sigaction action {};
    action.sa_handler = stop_or_end;
    action.sa_flags = SA_RESTART;  // what is being saved goes on
    endings.begin(action);
}

void unwatch_endings() {
    const std::lock_guard lock(users_mutex);
    endings.end();
}

}  // namespace

ToldWhenStopped::ToldWhenStopped() {
    tells = true;
    watch_endings();
}

ToldWhenStopped::~ToldWhenStopped() {
    unwatch_endings();
    tells = false;
}

StopOnInterrupt::StopOnInterrupt(std::optional<std::chrono::duration<double>> limit) {
    signalled = hung_up = false;
    work_stops = true;
    watch_endings();
    const auto start = std::chrono::steady_clock::now();
    watch_ = std::jthread([this, limit, start](const std::stop_token& done) {
        while (!done.stop_requested()) {
            const bool late = limit && std::chrono::steady_clock::now() - start >= *limit;
            if (signalled || late) {
                source_.request_stop();
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
}

StopOnInterrupt::~StopOnInterrupt() {
    watch_.request_stop();
    watch_.join();
    if (hung_up) {
        // The second time is not to cut short what is saved now.
        const std::lock_guard lock(users_mutex);
        endings.former[kHangup] = ignoring();
        ::sigaction(SIGHUP, &endings.former[kHangup], nullptr);
    }
    work_stops = false;
    unwatch_endings();
}

bool StopOnInterrupt::interrupted() {
    return signalled;
}

WriteErrorsInsteadOfSignals::WriteErrorsInsteadOfSignals() {
    const std::lock_guard lock(users_mutex);
    write_signals.begin(ignoring());
}

WriteErrorsInsteadOfSignals::~WriteErrorsInsteadOfSignals() {
    const std::lock_guard lock(users_mutex);
    write_signals.end();
}

}  // namespace dapple
