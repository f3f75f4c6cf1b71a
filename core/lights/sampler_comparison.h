#pragma once
// How well samples stand for their map: the errors of irradiance, and of a glossy surface's light, mean and
// largest, for each sampler and count.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/environment.h"
#include "core/lights/lit_objects.h"
#include "core/placing/stipple.h"
#include "core/text/names.h"

namespace dapple {

// Ways to take light samples from an environment map, ours and those it is compared with.

enum class LightSampler {
    uniform,     // directions at random over the sphere
    importance,  // at random in proportion to light: row, then column, by inverting the cumulative sums
    stratified,  // the same, with one random number in each of sqrt(n) x sqrt(n) equal squares
    sobol,       // the same, of Sobol' points with Owen's scrambling
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

// Sobol' points in two dimensions (1967), and Owen's scrambling (1995), which makes them random and keeps how
// evenly they lie: of the first 2^m, each of 2^m equal boxes has exactly one, however long and wide the
// boxes.

/// The point of that number, in [0, 1) and whole 2^-32.
glm::dvec2 sobol_point(std::uint32_t index);

/// Of such points, all of a set with the same seed.
glm::dvec2 scrambled(glm::dvec2 point, std::uint64_t seed);

struct ComparisonRequest {
    std::vector<std::uint64_t> counts{16, 64, 256, 1024, 4096, 16'384, 65'536};
    int normals = 1000;  // surfaces, evenly spread over the sphere
    int runs = 4;        // seeds 1 .. runs, over which errors are averaged
};

struct SamplerErrors {
    LightSampler sampler{};
    std::vector<RelativeError> irradiance{};  // one a count
    std::vector<RelativeError> glossy{};      // of cosine^kGlossy, one a count
    double slope = 0;  // of log mean error of irradiance over log count, least squares; -1/2: at random
};

struct LightComparison {
    ComparisonRequest request;
    std::vector<SamplerErrors> samplers;  // in the order of kLightSamplers
};

LightComparison compare_samplers(const EnvironmentMap& map, RankedTile& tile,
                                 const ComparisonRequest& request = {});

}  // namespace dapple
