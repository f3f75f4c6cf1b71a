#pragma once
// A little disorder before dots are relaxed.
//
// Placed dots lie alike wherever a tile comes again. Steps of relaxation follow from what is near: they even
// out what differs and leave what is alike, so that the period shows more after them than before. Carried a
// little way by a random flow first, dots settle differently each time. The flow swirls, and has no sources
// or sinks: an even tone stays even, and dots that are near each other move alike.

#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/image/density.h"
#include "core/maths/portable_math.h"
#include "core/placing/dots.h"
#include "core/placing/placing_table.h"
#include "core/relaxing/relax.h"

namespace dapple {

// Chance that follows from where a dot is, the same for any order of work.

/// From 0 to below 1, by place and time.
inline float chance_at(float x, float y, int step) {
    const std::uint64_t place =
        std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32 | std::bit_cast<std::uint32_t>(y);
    return static_cast<float>(portable::mixed(portable::mixed(place) + static_cast<std::uint64_t>(step)) >>
                              40) *
           0x1p-24f;
}

/// Whether a dot goes from where there is so much ink to where there is so much, by that chance: the seldomer
/// the more these differ, and in proportion to what is there (Metropolis et al. 1953), so that as many come
/// as go.
inline bool keeps_density(float here, float there, float chance) {
    const float ratio = there < here ? there / here : here / there;
    return there > 0 && chance < ratio * ratio * (there < here ? ratio : 1);
}

/// Without chance: a dot does not go where there is less than this share of the tone that it comes from.
inline constexpr float kLeastShare = 0.25f;

/// So often is a step tried that it cannot take, each time half as long.
inline constexpr int kShorterTries = 3;

/// How far the flow carries a dot at this place of the page where dots are so far apart, in page units.
/// Follows from these alone, to the bit.
glm::vec2 stirring_at(glm::vec2 place, float apart);

/// No dot that was placed at this scale is carried farther.
double farthest_stirred(double scale);

/// How much dots placed at this scale are to be stirred, 0..1: less where black would show only a few tiles,
/// and not at all where it would show two, as there hardly a dot comes again. Nor if the tile is a single one
/// that is never turned: it is used to see that it repeats.
double stirring_of(const PlacingTable& table, double scale);

/// Carries all dots along, so much. None leaves the page or the ink that it lies on.
void stir(DotPieces& dots, const Density& density, const RelaxingRequest& request);

}  // namespace dapple
