#include "core/lights/sampler_comparison.h"

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

double slope_of(std::span<const std::uint64_t> counts, std::span<const RelativeError> errors) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!(errors[i].mean > 0)) continue;
        const double x = portable::log(static_cast<double>(counts[i])), y = portable::log(errors[i].mean);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return spread > 0 ? (n * sxy - sx * sy) / spread : 0;
}

}  // namespace

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
            RelativeError& of_irradiance = result.irradiance.emplace_back();
            RelativeError& of_glossy = result.glossy.emplace_back();
            const auto average = [&request](RelativeError& so_far, const RelativeError& run) {
                so_far.mean += run.mean / request.runs;
                so_far.largest += run.largest / request.runs;
            };
            for (int run = 1; run <= request.runs; ++run) {
                const auto lights =
                    sampled_lights(map, tile, sampler, count, static_cast<std::uint64_t>(run));
                average(of_irradiance, relative_error(irradiance(lights, normals), exact));
                average(of_glossy, relative_error(irradiance(lights, normals, kGlossy), glossy));
            }
        }
        result.slope = slope_of(request.counts, result.irradiance);
        comparison.samplers.push_back(std::move(result));
    }
    return comparison;
}

}  // namespace dapple
