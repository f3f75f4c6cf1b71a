#include "app/viewer/model/lit_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/files/tile_library.h"
#include "core/lights/light_picture.h"

namespace dapple {
namespace {

constexpr int kPreviewWidth = 2048;

Grid<glm::vec3> preview_of(const EnvironmentMap& map) {
    const int times = (map.width() + kPreviewWidth - 1) / kPreviewWidth;
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

}  // namespace

LitMap::LitMap(EnvironmentMap environment)
    : map(std::move(environment)),
      exact(texel_lights(map)),
      natural_exposure(dapple::natural_exposure(map)),
      preview(preview_of(map)) {}

SampledMap sampled(const LitMap& lit, const LightsSettings& settings) {
    RankedTile tile = tile_named(settings.tile, RankingMethod::energy);
    const LightSamples lights = light_samples(lit.map, tile, settings.request);
    SampledMap result;
    std::vector<DistantLight> distant;
    glm::dvec3 sum{};
    for (const LightSample& sample : lights.samples) {
        result.places.push_back(sample.uv);
        distant.push_back({direction_of(sample.uv, SphereConvention::openexr), sample.weight});
        sum += sample.weight;
    }
    result.found.emplace(distant);
    result.info = {lights.place_ms, lights.share_ms, difference(*result.found, lit.exact),
                   std::abs(luminance(sum) / luminance(lights.total_flux) - 1)};
    return result;
}

}  // namespace dapple
