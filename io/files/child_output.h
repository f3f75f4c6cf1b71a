#pragma once
// The output of another of the desktop's programs, which is run, waited for, and ended if need be.

#include <chrono>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace dapple {

/// Whether a program of that name is in one of PATH's folders.
bool is_in_path(const std::string& program);

struct ChildLimits {
    std::size_t most_bytes = 1 << 20;
    std::optional<std::chrono::seconds> longest = {};  // none: as long as a person takes
};

struct ChildOutput {
    int status = 0;  // its exit status; -1: it was ended by a signal
    std::string bytes;
};

/// Runs a program found in PATH, without input, and gives back what it wrote into its standard output.
/// Nothing if it was stopped, which ends it. Throws std::runtime_error with one sentence if it cannot be
/// started, says more or takes longer than it may.
std::optional<ChildOutput> output_of(const std::vector<std::string>& words, const ChildLimits& limits,
                                     const std::stop_token& stop = {});

}  // namespace dapple
