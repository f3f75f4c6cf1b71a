#pragma once
// Waiting for what a test is after.

#include <chrono>
#include <thread>

namespace dapple {

/// Whether `done()` becomes true. Looks again and again for as long as ten minutes, so that no test depends on
/// how fast the machine is; only one that fails waits so long.
template <class Done>
bool wait_until(Done done) {
    constexpr std::chrono::milliseconds kBetweenLooks(10);
    constexpr std::chrono::minutes kPatience(10);
    const auto begin = std::chrono::steady_clock::now();
    while (!done()) {
        if (std::chrono::steady_clock::now() - begin > kPatience) return false;
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return true;
}

}  // namespace dapple
