#pragma once
// How many of something, as people type it: "40k".

#include <cstdint>
#include <optional>
#include <string_view>

namespace dapple {

/// A number: 0.25, 40000, 40,000, 40k, 1.5M, 2G, 1e5. Nothing if it is none. "10.000" is ten, not ten
/// thousand.
std::optional<double> quantity_of(std::string_view text);

/// The same if it is a whole number, to 10^15. "10.000" is none: it is ten to some and ten thousand to
/// others.
std::optional<std::uint64_t> count_of(std::string_view text);

}  // namespace dapple
