#pragma once
// How large dots are among each other, where they are not all alike.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "core/image/detail.h"

namespace dapple {

/// The areas of dots, over the largest's. Where they go by tone, smallest + (1 - smallest) * d at density d;
/// where they are finer, there are so many times as many, each with as much less. Densities are those of all
/// dots there, but where it says of the tone: what it would be if none were finer.
struct DotAreas {
    float smallest = 1;  // over 0; 1: all are alike, but for finer ones
    Refinement finer = {};

    bool differ() const { return smallest < 1 || !finer.empty(); }
    float at(float density, glm::dvec2 place) const {
        const float times = finer.times_at(place);
        return (smallest + (1 - smallest) * std::min(density / times, 1.0f)) / times;
    }
    float of_tone(float density, glm::dvec2 place) const { return density / finer.times_at(place); }
    /// The density, of the tone, whose dots have so much ink, which is density * at(density, place) wherever
    /// that is.
    float tone_of(float ink) const {
        if (!(smallest < 1) || ink >= 1) return ink;
        const float more = 1 - smallest, least = std::max(ink, 0.0f);
        return 2 * least / (smallest + std::sqrt(smallest * smallest + 4 * more * least));
    }
};

}  // namespace dapple
