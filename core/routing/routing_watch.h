#pragma once
// Progress and stopping, for whoever waits for a pen's way.

#include <functional>
#include <stop_token>

namespace dapple {

/// May be called from several threads, but not at the same time.
struct RoutingWatch {
    std::stop_token stop;                        // asks to give up
    std::function<void(double share)> progress;  // told now and then, 0..1, never backwards
};

}  // namespace dapple
