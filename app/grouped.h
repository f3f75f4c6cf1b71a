#pragma once

#include <cstdint>
#include <string>

namespace dapple {

/// A number as people write it: 12345 -> "12,345".
std::string grouped(std::uint64_t number);

}  // namespace dapple
