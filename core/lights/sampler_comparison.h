#pragma once
// How well samples stand for their map: the error of irradiance, and of a glossy surface's light, for each
// sampler and count.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/lights/samplers.h"

namespace dapple {

inline constexpr unsigned kGlossy = 50;

struct ComparisonRequest {
    std::vector<std::uint64_t> counts{16, 64, 256, 1024, 4096, 16'384, 65'536};
    int normals = 1000;  // surfaces, evenly spread over the sphere
    int runs = 4;        // seeds 1 .. runs, whose mean error is given
};

struct SamplerErrors {
    LightSampler sampler{};
    std::vector<double> errors{};         // of irradiance, one a count
    std::vector<double> glossy_errors{};  // of cosine^kGlossy, one a count
    double slope = 0;                     // of log error over log count, least squares; -1/2: at random
};

struct LightComparison {
    ComparisonRequest request;
    std::vector<SamplerErrors> samplers;  // in the order of kLightSamplers
};

/// Mean over normals of |E - exact| / exact, E and exact being the irradiance's luminance by these lights and
/// by all texels. Normals with no light at all are left out.
double irradiance_error(std::span<const glm::dvec3> found, std::span<const glm::dvec3> exact);

LightComparison compare_samplers(const EnvironmentMap& map, RankedTile& tile,
                                 const ComparisonRequest& request = {});

}  // namespace dapple
