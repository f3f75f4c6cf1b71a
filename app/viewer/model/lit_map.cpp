#include "app/viewer/model/lit_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lights/lit_objects.h"
#include "core/lights/settling.h"
#include "io/files/tile_library.h"

namespace dapple {
namespace {

constexpr int kPreviewWidth = 2048, kLightsWidth = 256;

// So many texels a side of a map become one, for it to be about that wide.
int texels_in_one(const EnvironmentMap& map, int width) {
    return (map.width() + width - 1) / width;
}

// A large map's texels are taken in blocks: one by one they take seconds, and minutes where there are
// hundreds of millions, and no surface shows the difference.
std::vector<DistantLight> lights_of(const EnvironmentMap& map) {
    const int times = texels_in_one(map, kLightsWidth);
    return times > 1 ? block_lights(map, times) : texel_lights(map);
}

Grid<glm::vec3> preview_of(const EnvironmentMap& map) {
    const int times = texels_in_one(map, kPreviewWidth);
    Grid<glm::vec3> preview(std::max(map.width() / times, 1), std::max(map.height() / times, 1));
    for (int y = 0; y < preview.height; ++y) {
        for (int x = 0; x < preview.width; ++x) {
            glm::vec3 sum{};
            for (int k = 0; k < times * times; ++k)
                sum += map.radiance().at(x * times + k % times, y * times + k / times);
            preview.at(x, y) = sum / static_cast<float>(times * times);
        }
    }
    return preview;
}

Grid<std::uint32_t> nearest_of(std::span<const DistantLight> lights, const Grid<glm::vec3>& preview) {
    const int height = std::max(preview.height, 1);
    const EnvironmentMap even(Grid<glm::vec3>(2 * height, height, glm::vec3(1)));
    const Grid<float> power(even.width(), even.height(), 1.0f);
    std::vector<glm::dvec3> directions;
    for (const DistantLight& light : lights) directions.push_back(light.direction);
    return TexelTree(even, power, 0).nearest_of(directions);
}

}  // namespace

LitMap::LitMap(EnvironmentMap environment)
    : map(std::move(environment)),
      exact(lights_of(map)),
      natural_exposure(dapple::natural_exposure(map)),
      preview(preview_of(map)) {}

std::optional<SampledMap> sampled(const LitMap& lit, const LightsSettings& settings, const Watch& watch) {
    RankedTile tile = tile_named(settings.tile, RankingMethod::energy);
    const LightSamples lights = light_samples(lit.map, tile, settings.request, watch);
    if (lights.samples.empty()) return std::nullopt;
    SampledMap result;
    std::vector<DistantLight> distant;
    glm::dvec3 sum{};
    for (const LightSample& sample : lights.samples) {
        result.places.push_back(sample.uv);
        distant.push_back({direction_of(sample.uv, SphereConvention::openexr), sample.weight});
        sum += sample.weight;
    }
    result.found.emplace(distant);
    result.info = {.place_ms = lights.place_ms,
                   .share_ms = lights.share_ms,
                   .irradiance = difference(result.found->diffuse, lit.exact.diffuse),
                   .glossy = difference(result.found->glossy, lit.exact.glossy),
                   .flux_error = std::abs(luminance(sum) / luminance(lights.total_flux) - 1)};
    result.nearest = nearest_of(distant, lit.preview);
    return result;
}

}  // namespace dapple
