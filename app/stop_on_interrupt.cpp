#include "app/stop_on_interrupt.h"

#include <array>
#include <atomic>
#include <csignal>

namespace dapple {
namespace {

// A signal handler is given nothing but the signal's number.
std::atomic<bool> signalled{false};
std::atomic<bool> hung_up{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the handler may not wait");

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kSignals.size()> former_actions;

}  // namespace

StopOnInterrupt::StopOnInterrupt(std::optional<std::chrono::duration<double>> limit) {
    signalled = hung_up = false;
    struct sigaction action {};
    action.sa_handler = [](int signal) {
        signalled = true;
        if (signal == SIGHUP) hung_up = true;
    };
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &former_actions[i]);
        // A terminal that closes says so twice, the shell and the system one after the other.
        action.sa_flags = kSignals[i] == SIGHUP ? 0 : static_cast<int>(SA_RESETHAND);
        // What nohup switched off stays off.
        if (former_actions[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &action, nullptr);
    }
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
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &former_actions[i], nullptr);
    // The second time is not to cut short what is saved now.
    if (hung_up) ::signal(SIGHUP, SIG_IGN);
}

bool StopOnInterrupt::interrupted() {
    return signalled;
}

}  // namespace dapple
