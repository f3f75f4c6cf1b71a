#pragma once
// Which of several dots of one critical scale comes first.
//
// A black area has very many such dots, one in each tile. Taken as they come they would fill the area from
// one side. So they come in the order of an ordered dither (Bayer 1973): every first part of them is spread
// over the area. It follows from a dot alone, so that drawings of all counts agree about it.

#include <compare>
#include <cstdint>

#include "core/placing/dots.h"

namespace dapple {

struct TieKey {
    std::uint32_t dither = 0;    // of a square of its tile's size, or a few times smaller
    std::uint64_t position = 0;  // its two numbers' bits: no two dots are at one place

    auto operator<=>(const TieKey&) const = default;
};

/// Dots that tie come by ascending key. Positions are in page units from the page's corner.
TieKey tie_key(float x, float y, float threshold);

}  // namespace dapple
