#pragma once
// A way through dots whose links do not cross.

#include <cstdint>
#include <span>
#include <vector>

#include "core/routing/short_way.h"

namespace dapple {

/// Improves an open way, the dots' indices, until no two of its links cross: where two do, the part between
/// them is turned round, which is always shorter (Flood 1956). Unlike moves between near dots it sees what a
/// long link leads past: each link looks, in a tree of boxes around links, for those that cross it or lie
/// about it, with which it could be exchanged for two shorter ones (2-opt), and for rows of one to three dots
/// that are on its way (Or-opt). The way is never longer than it was. All links are looked at side by side in
/// threads, and those that gain are moved in one: the result depends on the dots and the way alone. When
/// stopped, what was reached is left.
void uncross(std::span<const float> x, std::span<const float> y, std::vector<std::uint32_t>& way,
             const RoutingWatch& watch = {});

}  // namespace dapple
