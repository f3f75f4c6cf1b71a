#pragma once
// How many dots the window takes on: as many as fit into the computer's memory.

#include <cstdint>

namespace dapple {

/// As many dots as half of so many bytes of memory hold, both sides of a split view and saving included; at
/// least a million, at most kMostDots.
std::uint64_t most_dots_in(std::uint64_t bytes);

}  // namespace dapple
