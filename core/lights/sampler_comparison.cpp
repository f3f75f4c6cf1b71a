#include "core/lights/sampler_comparison.h"

#include <cmath>

namespace dapple {

namespace {

double slope_of(std::span<const std::uint64_t> counts, std::span<const double> errors) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!(errors[i] > 0)) continue;
        const double x = std::log(static_cast<double>(counts[i])), y = std::log(errors[i]);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return spread > 0 ? (n * sxy - sx * sy) / spread : 0;
}

}  // namespace

double irradiance_error(std::span<const glm::dvec3> found, std::span<const glm::dvec3> exact) {
    double sum = 0;
    int lit = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double right = luminance(exact[i]);
        if (!(right > 0)) continue;
        sum += std::abs(luminance(found[i]) - right) / right;
        ++lit;
    }
    return lit > 0 ? sum / lit : 0;
}

LightComparison compare_samplers(const EnvironmentMap& map, RankedTile& tile,
                                 const ComparisonRequest& request) {
    const std::vector<glm::dvec3> normals = fibonacci_normals(request.normals);
    const std::vector<DistantLight> texels = texel_lights(map);
    const std::vector<glm::dvec3> exact = irradiance(texels, normals),
                                  glossy = irradiance(texels, normals, kGlossy);
    LightComparison comparison{request, {}};
    for (const LightSampler sampler : kLightSamplers) {
        SamplerErrors result{.sampler = sampler};
        for (const std::uint64_t count : request.counts) {
            double sum = 0, glossy_sum = 0;
            for (int run = 1; run <= request.runs; ++run) {
                const auto lights =
                    sampled_lights(map, tile, sampler, count, static_cast<std::uint64_t>(run));
                sum += irradiance_error(irradiance(lights, normals), exact);
                glossy_sum += irradiance_error(irradiance(lights, normals, kGlossy), glossy);
            }
            result.errors.push_back(sum / request.runs);
            result.glossy_errors.push_back(glossy_sum / request.runs);
        }
        result.slope = slope_of(request.counts, result.errors);
        comparison.samplers.push_back(std::move(result));
    }
    return comparison;
}

}  // namespace dapple
