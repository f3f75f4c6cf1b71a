#include "core/lights/light_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/lights/direction.h"
#include "core/lights/regions.h"
#include "core/tile/neighbours.h"
#include "core/tile/random.h"

namespace dapple {

namespace {

constexpr double kPlacingShare = 0.4;  // of the time that samples take: most of it for the density

class Stopwatch {
 public:
    double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The places of the dots that Figure 8 emits, each once: the `count` of them that appear first as its scale
// grows.
std::vector<glm::dvec2> figure8_dots(const RankedTile& tile, const Density& density, std::uint64_t count,
                                     const std::stop_token& stop) {
    const auto placed = place_figure8_count(density, tile.tile(), tile.own_ranks(), count, stop);
    if (!placed) return {};
    const Dots& dots = placed->dots;
    struct Place {
        float x, y;
        double critical;
    };
    std::vector<Place> places(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const double here = density.at({dots.x[i], dots.y[i]});
        places[i] = {dots.x[i], dots.y[i],
                     here > 0 ? dots.threshold[i] / here : std::numeric_limits<double>::max()};
    }
    std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.y, p.x, p.critical); });
    const auto alike = [](const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; };
    places.erase(std::unique(places.begin(), places.end(), alike), places.end());
    std::ranges::stable_sort(places, {}, &Place::critical);
    std::vector<glm::dvec2> chosen(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < count; ++i) chosen[i] = {places[i].x, places[i].y};
    return chosen;
}

std::vector<glm::dvec2> exact_dots(RankedTile& tile, const Density& density, const LightRequest& request,
                                   const std::stop_token& stop) {
    DotPieces dots;
    if (!tile.placer().place(density, {.count = request.count, .threads = request.threads}, dots, stop))
        return {};
    std::vector<glm::dvec2> places;
    places.reserve(dots.size());
    for_each_position(dots, [&](float x, float y) { places.emplace_back(x, y); });
    return places;
}

}  // namespace

std::vector<glm::dvec2> light_dots(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                                   const std::stop_token& stop) {
    if (request.count < 1 || request.count > kMostLightSamples) {
        throw std::runtime_error(
            fmt::format("{} samples are not possible; ask for 1 to {}", request.count, kMostLightSamples));
    }
    const int turn =
        request.seed == 0
            ? 0
            : static_cast<int>(Random(request.seed).below(static_cast<std::size_t>(map.width())));
    const Density density = light_density(map, request.importance, turn);
    std::vector<glm::dvec2> places = request.placer == PlacerKind::figure8
                                         ? figure8_dots(tile, density, request.count, stop)
                                         : exact_dots(tile, density, request, stop);
    for (glm::dvec2& p : places) {
        p.x += static_cast<double>(turn) / map.width();
        if (p.x >= 1) p.x -= 1;
        p.y = std::min(2 * p.y, 1.0);  // the page's unit is the map's width
    }
    return places;
}

LightSamples light_samples(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                           const LightWatch& watch) {
    if (request.radiance == SampleRadiance::point && request.position != SamplePosition::random)
        throw std::runtime_error(
            "the radiance at a sample's point needs a random position: other points have no density");
    LightSamples result{.position = request.position,
                        .radiance = request.radiance,
                        .seed = request.seed,
                        .total_flux = map.total_flux()};
    const Stopwatch placing;
    const std::vector<glm::dvec2> dots = light_dots(map, tile, request, watch.stop);
    if (!watch.goes_on(kPlacingShare)) return result;
    result.place_ms = placing.ms();

    const Stopwatch sharing;
    const bool drawn = request.position == SamplePosition::random;
    const LightWatch while_sharing{
        watch.stop, [&watch](double share) { watch.goes_on(kPlacingShare + (1 - kPlacingShare) * share); }};
    const std::vector<LightRegion> regions =
        share_light(map, dots, drawn ? std::optional(request.seed) : std::nullopt, while_sharing);
    if (regions.empty()) return result;
    result.samples.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const LightRegion& region = regions[i];
        LightSample& sample = result.samples[i];
        sample.uv = dots[i];
        if (request.position == SamplePosition::centroid && glm::length(region.moment) > 0)
            sample.uv = uv_of(region.moment, SphereConvention::openexr);
        if (request.position == SamplePosition::random && region.luminance > 0) sample.uv = region.drawn;
        sample.weight = region.flux;
        sample.radiance = region.flux / region.solid_angle;
        double density = 1 / region.solid_angle;
        if (request.radiance == SampleRadiance::point && region.luminance > 0) {
            sample.radiance = map.at(sample.uv);
            density = luminance(sample.radiance) / region.luminance;
        }
        sample.pdf = density / static_cast<double>(dots.size());
    }
    result.share_ms = sharing.ms();
    return result;
}

bool meets_itself(const Tile& tile) {
    return std::ranges::any_of(legal_neighbours(tile.rule, tile.next_kind), [](const Neighbour& neighbour) {
        return neighbour.of == 0 && neighbour.kind == 0 && neighbour.offset == glm::ivec2(1, 0) &&
               neighbour.orientation == Orientation{};
    });
}

}  // namespace dapple
