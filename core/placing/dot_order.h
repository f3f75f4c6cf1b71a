#pragma once
// The order in which dots are drawn and written.

#include <compare>
#include <cstdint>
#include <string_view>

#include "core/placing/dots.h"
#include "core/text/names.h"

namespace dapple {

// Which of several dots of one critical scale comes first.
//
// A black area has very many such dots, one in each tile. Taken as they come they would fill the area from
// one side. So they come in the order of an ordered dither (Bayer 1973): every first part of them is spread
// over the area. It follows from a dot alone, so that drawings of all counts agree about it.

struct TieKey {
    std::uint32_t dither = 0;    // of a square of its tile's size, or a few times smaller
    std::uint64_t position = 0;  // its two numbers' bits: no two dots are at one place

    auto operator<=>(const TieKey&) const = default;
};

/// Dots that tie come by ascending key. Positions are in page units from the page's corner.
TieKey tie_key(float x, float y, float threshold);

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
/// order of TieKey below. For `shortest` it makes the start, which is `space`;
/// core/routing/short_way.h has the rest.
void sort_dots(Dots& dots, DotOrder order);

}  // namespace dapple
