#pragma once
// Progress and stopping, for whoever waits.

#include <functional>
#include <stop_token>

namespace dapple {

/// Both may be called from several threads, but not at the same time.
struct Watch {
    std::stop_token stop;                        // asks to give up
    std::function<void(double share)> progress;  // called now and then, 0..1, never backwards

    /// Reports how far it is. False: it is to be given up.
    bool goes_on(double share) const {
        if (stop.stop_requested()) return false;
        if (progress) progress(share);
        return true;
    }
};

}  // namespace dapple
