#pragma once
// Local contrast, so that what is faint survives being drawn in dots.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "core/image/grid.h"
#include "core/image/mask.h"

namespace dapple {

// Gaussian blur of a grid.

/// Blurs with a Gaussian of standard deviation sigma pixels (>= 0; 0 changes nothing), the edge pixels going
/// on outside. Three running means, whose cost does not depend on sigma (Wells 1986), within 3 % of a
/// Gaussian.
Grid<float> blurred(Grid<float> grid, double sigma);

// Where a drawing's dots are finer, as a mask has it: there are so many times as many of them on an area,
// each with as much less of it, so that the tone stays.

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

/// The scale up to which dots need help: four mean spacings of `dots` dots on a picture of that many pixels,
/// as the standard deviation in pixels that with_detail() takes. Dots draw nothing narrower than their
/// spacing: what stands out has to be some spacings wide, and so has the light beside it. Rounded to a power
/// of the root of two, so that it stays while the number of dots changes a little.
double detail_sigma(double pixels, double dots);

/// The amount that automatic tone is best used with, chosen by looking: fur and grain of wood are there,
/// which without it are not, and beyond it grain grows faster than what is gained. On photographs drawn with
/// 40,000 dots it changes how gradients follow the photograph's by less than 0.01 of correlation.
inline constexpr float kAutoDetail = 0.5f;

/// A picture of linear light (clamped and NaN white as density_of() takes it) whose faint detail, such as
/// whiskers or a retina's vessels, stands out more.
///
/// Works on the sRGB-encoded value v, along which steps look even. With m and s the mean and the standard
/// deviation of v under a Gaussian of sigma_px (> 0) about the pixel, the result is
///
///     v + amount * limited(1.5 * (v - m) * e^2 / (s^2 + e^2)),   e = 0.1
///
/// The last factor leaves strong edges alone, about which there would be halos otherwise (the weight of Lee's
/// 1980 filter and of the guided filter, He et al. 2010). limited(d) = d / (1 + |d| / 0.15), so no value
/// moves by more than amount * 0.15. Flat parts stay as they are, and so does the mean of v, but for edges
/// and clamping to 0..1.
///
/// amount: 0 returns the very same values; 1 is strong; more is allowed. Means of over 6 pixels are worked
/// out on fewer pixels; time and memory are those of the picture.
Grid<float> with_detail(Grid<float> light, double amount, double sigma_px);

// How large dots are among each other, where they are not all alike.

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
