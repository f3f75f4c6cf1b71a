#pragma once
// Waiting for what a test is after.

#include <chrono>
#include <thread>

namespace dapple {

/// Whether `done()` becomes true. Looks again and again for as long as a minute, so that few tests depend on
/// how fast the machine is; only one that fails waits so long.
template <class Done>
bool wait_until(Done done) {
    constexpr std::chrono::milliseconds kBetweenLooks(10);
    constexpr std::chrono::seconds kPatience(60);
    const auto begin = std::chrono::steady_clock::now();
    while (!done()) {
        if (std::chrono::steady_clock::now() - begin > kPatience) return false;
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return true;
}

}  // namespace dapple
