#pragma once
// Files that are nearly right: where readers go wrong.

#include <random>
#include <string>

namespace dapple {

/// A seed with a few random changes: bits turned, numbers made extreme, stretches taken out, doubled or
/// swapped, the end cut off; in text also digits and signs.
std::string mutated(std::string bytes, std::mt19937_64& random);

}  // namespace dapple
