#pragma once
// How much memory there is, and whether it is enough for what is about to begin.

#include <cstdint>
#include <optional>
#include <string_view>

namespace dapple {

/// Memory that a program can still get without others having to give way, in bytes: what the system says is
/// available now, and what a control group or a limit (ulimit -v) that the program runs under leaves of it.
std::uint64_t available_memory();

/// Throws std::runtime_error if so many bytes are not there: "1,000 dots in the shortest order" need them.
/// `allowed` is what someone says in place of what is available.
void check_memory(double bytes, std::string_view what, const std::optional<double>& allowed);

}  // namespace dapple
