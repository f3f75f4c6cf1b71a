#pragma once
// Waiting for what a test is after.

#include <time.h>

#include <chrono>
#include <thread>

namespace dapple {

/// How much whoever works may work before a test gives up waiting, in processor time, which is the same on
/// a machine that is busy with other things; and how long one that does nothing is waited for.
struct Patience {
    clockid_t work = CLOCK_PROCESS_CPUTIME_ID;  // of the process that works, with all its threads
    std::chrono::seconds of_work{60}, of_all{600};
};

/// Whether `done()` becomes true. Looks again and again; only a test that fails waits to the end.
template <class Done>
bool wait_until(Done done, const Patience& patience = {}) {
    constexpr std::chrono::milliseconds kBetweenLooks(10);
    const auto worked = [&] {
        timespec time{};  // none: the process has ended
        clock_gettime(patience.work, &time);
        return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    };
    const auto begin = std::chrono::steady_clock::now();
    const auto begin_of_work = worked();
    while (!done()) {
        if (worked() - begin_of_work > patience.of_work ||
            std::chrono::steady_clock::now() - begin > patience.of_all)
            return false;
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return true;
}

}  // namespace dapple
