#pragma once
// How many dots the window takes on: as many as fit into the computer's memory.

#include <cstdint>

namespace dapple {

/// Memory that a program can still get without others having to give way, in bytes: what the system says is
/// available now, and what a control group that the program runs in leaves of it.
std::uint64_t available_memory();

/// As many dots as half of that memory holds, both sides of a split view and saving included; at least a
/// million, at most kMostDots.
std::uint64_t most_dots_in(std::uint64_t bytes);

}  // namespace dapple
