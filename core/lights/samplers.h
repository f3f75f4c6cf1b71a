#pragma once
// Ways to take light samples from an environment map, ours and those it is compared with.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/image/environment.h"
#include "core/lights/irradiance.h"
#include "core/placing/stipple.h"
#include "core/text/names.h"

namespace dapple {

enum class LightSampler {
    uniform,     // directions at random over the sphere
    importance,  // at random in proportion to light: row, then column, by inverting the cumulative sums
    stratified,  // the same, with one random number in each of sqrt(n) x sqrt(n) equal squares
    sobol,       // the same, of Sobol' points with Owen's scrambling (core/lights/sobol.h)
    median_cut,  // the map cut into rectangles of like light, again and again, the brightest first; a light
                 // in the middle of each one's (Debevec 2005)
    unbiased,    // ours, SamplePosition::random
    settled,     // ours, SamplePosition::settled
};
constexpr auto names_of(LightSampler) {
    return names("uniform random", "importance random", "stratified inversion", "owen-scrambled sobol",
                 "median cut", "dapple, unbiased", "dapple");
}

inline constexpr LightSampler kLightSamplers[] = {
    LightSampler::uniform,    LightSampler::importance, LightSampler::stratified, LightSampler::sobol,
    LightSampler::median_cut, LightSampler::unbiased,   LightSampler::settled};

/// Inverts the cumulative luminance of a map (Pharr, Jakob & Humphreys, Physically Based Rendering, 2-D
/// piecewise constant distributions).
class LightInversion {
 public:
    explicit LightInversion(const EnvironmentMap& map);

    /// The place on the map that two numbers in [0, 1) lead to; u by the first, v by the second. Within a
    /// texel even in solid angle.
    struct Place {
        glm::dvec2 uv;
        int column, row;
    };
    Place at(double s, double t) const;

    double total() const { return rows_.back(); }  // luminance of the map's flux

 private:
    int width_, height_;
    std::vector<double> rows_;     // cumulative, one more than there are
    std::vector<double> columns_;  // the same within each row
};

/// `count` lights (a square number for the stratified ones, else the next lower square), each with the weight
/// radiance / (count pdf) or, of ours, that of its region. The radiance is the texel's.
std::vector<DistantLight> sampled_lights(const EnvironmentMap& map, RankedTile& tile, LightSampler sampler,
                                         std::uint64_t count, std::uint64_t seed);

}  // namespace dapple
