#pragma once
// A short way for a pen through all dots: an open path, the travelling salesman's without the way home.

#include <cstdint>
#include <span>
#include <vector>

#include "core/placing/dots.h"
#include "core/watch.h"

namespace dapple {

// A way through dots made of the shortest links between them: a good beginning for one that is improved.

/// The dots' indices along an open way. The shortest of all links between near dots that joins two pieces of
/// the way is taken, and then the next (the greedy heuristic: Bentley, "Fast algorithms for geometric
/// traveling salesman problems", ORSA J. Computing 4, 1992); once near dots have none left, links between the
/// pieces' ends. Random dots' ways are about a sixth longer than the shortest, where those along a Hilbert
/// curve are a third longer. The first or the last dot, or both, can be held: then the way begins or ends
/// there. `near` is near_dots(x, y).
std::vector<std::uint32_t> greedy_way(std::span<const float> x, std::span<const float> y,
                                      std::span<const std::uint32_t> near, bool holds_first, bool holds_last);

/// The dots' indices in an order whose way is never longer than the one given. The dots should be sorted
/// along a Hilbert curve (core/placing/dot_order.h), so that consecutive ones are near each other.
///
/// A greedy way is improved by moves until none helps: 2-opt (Croes 1958), which turns a part
/// of the way round, and Or-opt (Or 1976), which carries one to three dots in a row elsewhere. Both look only
/// at each dot's nearest others and at dots whose surroundings changed (neighbour lists and don't-look bits:
/// Bentley, "Fast algorithms for geometric traveling salesman problems", ORSA J. Computing 4, 1992; Johnson
/// and McGeoch, "The traveling salesman problem: a case study in local optimization", 1997).
///
/// Many dots are improved in windows of consecutive ones, side by side in threads. What is then left, above
/// all along windows' borders and long links, is improved as a whole until no two links cross.
///
/// The result depends on the dots alone: not on time, nor on the number of threads, so that window and
/// command, and every machine, write the same file. That is why there is no limit in seconds: whoever cannot
/// wait stops it. Throws nothing of its own; when stopped, what was reached is returned.
std::vector<std::uint32_t> short_way(std::span<const float> x, std::span<const float> y,
                                     const Watch& watch = {});

/// Puts the dots, sorted along a Hilbert curve, in the order of short_way().
void shorten_way(Dots& dots, const Watch& watch = {});

/// The length of the way through dots as they come, in their unit.
double way_length(std::span<const float> x, std::span<const float> y);

/// The same through dots in the order of those indices.
double way_length(std::span<const float> x, std::span<const float> y, std::span<const std::uint32_t> order);

}  // namespace dapple
