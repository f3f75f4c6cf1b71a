#include "dapple/lights.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "bindings/library/state.h"
#include "core/drawing/settings.h"
#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/tile/tile_file.h"

namespace dapple {

std::vector<SampledLight> sample_lights(std::span<const float> radiance, int width, int height,
                                        const LightSampling& sampling) {
    const bool sides = width >= 1 && height >= 1;
    if (!sides || radiance.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::runtime_error(
            fmt::format("{} values for a map of {} x {} texels of three", radiance.size(), width, height));
    Grid<glm::vec3> texels(width, height);
    for (std::size_t i = 0; i < texels.values.size(); ++i)
        texels.values[i] = {radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2]};
    RankedTile tile = ranked_tile(*built_in_tile(kDefaultTile));
    const LightSamples found = light_samples(
        EnvironmentMap(std::move(texels)), tile,
        {.count = sampling.count, .seed = sampling.seed, .threads = checked_threads(sampling.threads)});
    std::vector<SampledLight> lights;
    lights.reserve(found.samples.size());
    for (const LightSample& sample : found.samples) {
        const glm::dvec3 to = direction_of(sample.uv, SphereConvention::openexr);
        lights.push_back({.direction = {to.x, to.y, to.z},
                          .u = sample.uv.x,
                          .v = sample.uv.y,
                          .weight = {sample.weight.r, sample.weight.g, sample.weight.b},
                          .pdf = sample.pdf});
    }
    return lights;
}

}  // namespace dapple
