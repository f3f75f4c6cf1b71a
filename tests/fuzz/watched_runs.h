#pragma once
// Many runs of something that may crash, hang or eat memory, each watched from another process.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dapple {

struct WatchedRequest {
    std::uint64_t first = 0, runs = 0;
    double seconds = 1e9;  // no more is begun after that
    // In processor time, which does not depend on what else the machine does. A run that takes longer is
    // ended, and so is one that takes twenty times as long by the clock, as it waits for something.
    double longest_run_seconds = 30;
};

struct WatchedResult {
    std::uint64_t runs = 0;
    struct Ended {
        std::uint64_t run = 0;
        std::string how;  // "Segmentation fault", "exit 1", "over 30 s", "waits for ever"
    };
    std::vector<Ended> ended;
    double longest_seconds = 0;
    std::uint64_t most_memory = 0;  // bytes, of a process
};

/// Does `run` for numbers from `first` on, in child processes. One that ends its process is written down and
/// the next begins in a new one.
WatchedResult watched_runs(const WatchedRequest& request, const std::function<void(std::uint64_t)>& run);

}  // namespace dapple
