#pragma once
// A way through dots made of the shortest links between them: a good beginning for one that is improved.

#include <cstdint>
#include <span>
#include <vector>

namespace dapple {

/// The dots' indices along an open way. The shortest of all links between near dots that joins two pieces of
/// the way is taken, and then the next (the greedy heuristic: Bentley, "Fast algorithms for geometric
/// traveling salesman problems", ORSA J. Computing 4, 1992); once near dots have none left, links between the
/// pieces' ends.
/// Random dots' ways are about a sixth longer than the shortest, where those along a Hilbert curve are a
/// third longer. The first or the last dot, or both, can be held: then the way begins or ends there.
/// `near` is near_dots(x, y).
std::vector<std::uint32_t> greedy_way(std::span<const float> x, std::span<const float> y,
                                      std::span<const std::uint32_t> near, bool holds_first, bool holds_last);

}  // namespace dapple
