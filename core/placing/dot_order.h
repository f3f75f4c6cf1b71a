#pragma once
// The order in which dots are drawn and written.

#include <string_view>

#include "core/placing/dots.h"
#include "core/text/names.h"

namespace dapple {

enum class DotOrder {
    shortest,   // as space, then improved by core/routing: 2-opt and Or-opt
    space,      // along a Hilbert curve: each dot near the one before, for pens and for locality
    recursion,  // as placed: each tile's newborn points, then its quadrants'
    priority,   // by critical scale: the first n dots are the drawing with n dots
};
constexpr auto names_of(DotOrder) {
    return names("shortest", "space", "recursion", "priority");
}

/// Sorts dots. For priority Dots::threshold and Dots::critical have to be filled; dots that tie come in the
/// order of core/placing/tie_order.h. For `shortest` it makes the start, which is `space`;
/// core/routing/short_way.h has the rest.
void sort_dots(Dots& dots, DotOrder order);

}  // namespace dapple
