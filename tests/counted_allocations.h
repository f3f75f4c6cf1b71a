#pragma once
// How often the program has asked for memory with new.

#include <cstddef>

namespace dapple {

std::size_t allocations();

}  // namespace dapple
