#pragma once
// Where a drawing's dots are finer, as a mask has it: there are so many times as many of them on an area,
// each with as much less of it, so that the tone stays.

#include <glm/vec2.hpp>

#include "core/image/framing.h"
#include "core/image/mask.h"

namespace dapple {

class Refinement {
 public:
    /// Nowhere.
    Refinement() = default;
    /// On the page of a picture of so many pixels that is framed so.
    Refinement(const Mask& mask, const Framing& framing, glm::ivec2 picture);

    bool empty() const { return mask_.empty(); }

    /// How many times as many dots there are at a point of the page, 1..kMostTimesFiner: times_finer() of the
    /// mask. The same bits for the same point, whichever part of the page it was asked for.
    float times_at(glm::dvec2 place) const {
        return empty()
                   ? 1
                   : times_finer(level_at(mask_.fineness(), corner_ + place.x * across_ + place.y * down_));
    }
    /// The most that there is anywhere.
    float most_times() const { return most_times_; }
    /// And the least: not 1 only where all of the picture is finer.
    float least_times() const { return least_times_; }

 private:
    Mask mask_;                                   // with finer dots, or none
    glm::dvec2 corner_{0}, across_{0}, down_{0};  // of the page, and a page unit of it, in the mask's pixels
    float least_times_ = 1, most_times_ = 1;
};

}  // namespace dapple
