#pragma once
// Progress and stopping, for whoever waits for light samples: with a map of many megapixels they take
// seconds.

#include <functional>
#include <stop_token>

namespace dapple {

struct LightWatch {
    std::stop_token stop;                        // asks to give up
    std::function<void(double share)> progress;  // told now and then, 0..1, never backwards

    /// Tells how far it is. False: it is to be given up.
    bool goes_on(double share) const {
        if (stop.stop_requested()) return false;
        if (progress) progress(share);
        return true;
    }
};

}  // namespace dapple
