#pragma once
// Each dot's nearest others, for whoever looks for short moves between them.

#include <cstdint>
#include <span>
#include <vector>

namespace dapple {

inline constexpr std::size_t kNearDots = 8;

/// For dot i the entries from kNearDots * i on: indices of its nearest others, the nearest first. Where there
/// are fewer others, the last is repeated; a single dot has itself. By a k-d tree (Bentley 1975), so that
/// dots may lie as unevenly as they like.
std::vector<std::uint32_t> near_dots(std::span<const float> x, std::span<const float> y);

/// The same for any number of others, at least 1, on so many threads; 0: all cores.
std::vector<std::uint32_t> near_dots(std::span<const float> x, std::span<const float> y, std::size_t count,
                                     int threads);

}  // namespace dapple
