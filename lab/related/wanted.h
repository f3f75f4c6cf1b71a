#pragma once
// What every method of this room is asked for.
//
// The methods are those that dapple is compared with, each from its own paper: plain programs, made to be
// right and of the cost that the paper gives, and not tuned.

#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <stop_token>
#include <vector>

#include "core/image/density.h"

namespace dapple {

struct DotsWanted {
    /// A picture's density, whose page is a cut-out; none: constant, on the unit square whose opposite edges
    /// meet.
    const Density* density = nullptr;
    std::size_t count = 0;
    std::uint64_t seed = 1;  // the same dots for the same seed, on every machine
    std::stop_token stop{};
};

/// Page units; 0 <= x, y < 1 on the unit square, on the page of a picture. None if a stop was requested.
using PlainDots = std::vector<glm::dvec2>;

/// What the dots fill: the picture's page, or the unit square.
inline glm::dvec2 page_of(const DotsWanted& wanted) {
    if (!wanted.density) return {1, 1};
    return glm::dvec2(wanted.density->width(), wanted.density->height()) /
           double(wanted.density->longer_side());
}

/// The place on the unit square, whose opposite edges meet: 0 <= x, y < 1.
inline glm::dvec2 on_unit_torus(glm::dvec2 p) {
    const glm::dvec2 inside = p - glm::floor(p);  // 1 where p is just below a whole number
    return {inside.x < 1 ? inside.x : 0, inside.y < 1 ? inside.y : 0};
}

}  // namespace dapple
