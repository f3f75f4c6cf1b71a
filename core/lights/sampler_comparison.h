#pragma once
// How well samples stand for their map: the errors of irradiance, and of a glossy surface's light, mean and
// largest, for each sampler and count.

#include <cstdint>
#include <vector>

#include "core/lights/samplers.h"

namespace dapple {

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
